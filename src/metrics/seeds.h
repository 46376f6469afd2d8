#pragma once

#include "image/image.h"

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace orbs::metrics {

/// Whether all images are bit-equal, as those of a renderer that ignores its seed or of a scene without
/// noise.
bool are_equal(const std::vector<image::Image>& images);

/// What is said of a renderer whose renders with different seeds are.
inline constexpr std::string_view kEqualSeeds =
    "renders with different seeds are equal to the bit: the renderer ignores its seed, or the scene has no noise";

/// The mean of the images in R, G, B. At least one, all of one size, is the caller's promise.
image::Image mean_of(const std::vector<image::Image>& images);

/// Attributes in which a render counts what it had to leave out or to guess: samples that were no finite
/// number, searches for a root of a formula that reached their limit, answers of plug-ins that broke the
/// rules, points of formulas without a gradient, roots of which rounding left open whether they are there,
/// and what an irradiance cache set to zero.
inline constexpr std::array kCounters{"orbs.bad_samples",  "orbs.unfinished_roots", "orbs.plugin_faults",
                                      "orbs.zero_normals", "orbs.undecided_roots",  "orbs.cache_negative"};

/// The attributes with the counts of samples and of kCounters of all images together, where each states
/// them; those of one render are not those of their mean.
std::map<std::string, std::string> with_sample_counts(std::map<std::string, std::string> attributes,
                                                      const std::vector<image::Image>& images);

/// The mean of renders of one scene with different seeds in all their channels, and the variance of that mean
/// in "variance.R/G/B" and, where they have Stokes parameters, "variance.S1.R" and so on, from the scatter of
/// the renders: s^2 / n with n - 1 degrees of freedom. With two or three seeds that is
/// rough in each pixel, yet not biased, and test_noise pools it over blocks and the image. For renderers
/// that do not know their noise; their images must not be filtered over pixels. Attributes are those of the
/// first. InputError for less than two images, for different sizes or channels, and for images that are all
/// equal, as those of a renderer that ignores its seed are.
image::Image mean_and_variance_of(const std::vector<image::Image>& images);

}  // namespace orbs::metrics

#pragma once

#include "image/image.h"
#include "registry/analytic.h"
#include "scene/scene.h"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace orbs::analytic {

/// What its images have: R, G, B, and of polarised light S1.R to S3.B.
std::vector<std::string> analytic_channels(const registry::AnalyticImage& formula);

/// The image that the formula gives for this camera: its channels, each pixel the mean over its square to
/// about 1e-6 of its value, 1e-4 where an edge crosses it. No renderer has a part in it. InputError where the
/// formula has no closed form for its numbers.
image::Image analytic_image(const registry::AnalyticImage& formula, const scene::Camera& camera);

/// Some pixels of that image, by column and row, all channels of one after those of the other; for where the
/// whole image takes minutes.
std::vector<float> analytic_pixels(const registry::AnalyticImage& formula,
                                   const scene::Camera& camera,
                                   std::span<const std::array<int, 2>> pixels);

}  // namespace orbs::analytic

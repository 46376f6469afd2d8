#pragma once

#include "image/image.h"
#include "studies/probe/primary_visibility.h"
#include "studies/probe/scene.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace orbs::studies {

/// Pixels that should show one object, or the background, and do not.
struct Mismatch {
  int object = kNoObject;  // the expected one
  int pixels = 0;
  int x = 0;  // the first of these pixels
  int y = 0;
  std::string instead;  // what most of these pixels show
};

struct ProbeFindings {
  int compared = 0;                      // pixels that one object covers completely
  std::vector<Mismatch> mismatches;      // those of most pixels first
  int cracks = 0;                        // single pixels that show something behind; not among the mismatches
  std::optional<double> needed_samples;  // so many times more, since noise hides what is compared
};

/// A pixel that does not show what covers it.
struct Suspect {
  int object = kNoObject;  // the expected one
  Pixel at;
  std::string instead;
};

/// By object, those of most pixels first. Where they are few, pixels that show several objects on a fine grid
/// are left out.
std::vector<Mismatch> mismatches_of(const ProbeScene& probe, std::vector<Suspect> suspects);

/// The object that all points of a pixel see; none if they see several.
std::optional<int> only_object(std::span<const VisibleSurface> surfaces);

/// Compares the image of the id pass. A pixel counts if all its points see the same object, because then a
/// pixel filter no wider than one pixel can only give that object's colour. Both comparisons leave room for
/// the noise that the image's variances state.
ProbeFindings compare_id_pass(const ProbeScene& probe,
                              const std::vector<VisibleSurface>& surfaces,
                              const image::Image& image);

/// What the surfaces of a uv pass show of the ramp: itself, or its ratios to blue, see ratios_to_blue.
enum class Ramp { Emitted, Reflected };

/// Red and green in units of blue, which is then 1: coordinates, from the image of a reflecting uv pass, in
/// which blue is 1 on the ramp. Black where there is next to no light to divide by.
image::Image ratios_to_blue(const image::Image& image);

/// Compares the image of the uv pass. A pixel counts if its coordinates stay within one period of the ramp
/// and change slowly enough that the texture filter does not matter.
/// Of a reflecting pass, a pixel without light does not count. `step` is what the texture's own precision
/// takes off its values.
ProbeFindings compare_uv_pass(const ProbeScene& probe,
                              const std::vector<VisibleSurface>& surfaces,
                              const image::Image& image,
                              Ramp ramp = Ramp::Emitted,
                              double step = 0);

}  // namespace orbs::studies

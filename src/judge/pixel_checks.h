#pragma once

#include "image/image.h"
#include "registry/case.h"
#include "results/record.h"

namespace orbs::judge {

/// Measures the region's mean and compares it as the check says; not measured where it says why not. The
/// image holds the region.
results::Check check_pixels(const registry::PixelCheck& check, const image::Image& image);

/// Of a check that was measured and has not passed: Fail, or Inconclusive where as many standard errors as
/// the check allows could have moved the mean so far. Inconclusive, too, where light is expected and an image
/// that states its noise is black with none: no sample has met the light.
results::Verdict verdict_of_missed_check(const registry::PixelCheck& check, const image::Image& image);

/// How far the mean is off, in tolerances; infinite where none is given.
double excess_of_missed_check(const registry::PixelCheck& check, const image::Image& image);

}  // namespace orbs::judge

#pragma once

#include "tracer/render/rendering.h"
#include "tracer/world/world.h"

#include <string>

namespace orbs::tracer_cli {

/// The exit status of a render whose image is written and lacks too much.
constexpr int kTooMuchMissing = 4;

/// What the image lacks, or has in the place of answers, beyond kMostBadSamples_ppm of its samples: "120 of
/// 4096 samples were not finite, 2.93e+04 in a million"; "" where it is less.
std::string too_much_missing(const tracer::Rendering& rendering, const tracer::World& world);

}  // namespace orbs::tracer_cli

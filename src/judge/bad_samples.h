#pragma once

#include "image/image.h"
#include "judge/gate.h"
#include "results/record.h"

#include <optional>

namespace orbs::judge {

/// The largest share of an image's samples that may be missing because they came out as no finite number, in
/// millionths, and the largest number of rays over that of samples that may have missed a surface because its
/// shape did not answer. Where all of them lie in one tile of 16 x 16 px of an image of 512 x 512 px, a
/// 1024th of it, the tile lacks a tenth of its samples, and a tenth of its light is what the gate local_bias
/// allows.
inline constexpr double kMostBadSamples_ppm = 100;

/// Looks at what the image itself states (metrics::kCounters and orbs.spp). Above the limit: Fail,
/// with the number and the check in the record. Up to it, and where the share cannot be told, a remark says
/// how many there are. Nothing where the image states none.
std::optional<GateResult> check_bad_samples(const image::Image& result, results::TargetRecord& record);

}  // namespace orbs::judge

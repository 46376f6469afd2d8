#pragma once

#include "image/image.h"
#include "judge/gate.h"
#include "results/record.h"

#include <optional>

namespace orbs::judge {

/// Looks at what the image itself states (metrics::kCounters and orbs.spp). Above kMostBadSamples_ppm: Fail,
/// with the number and the check in the record. Up to it, and where the share cannot be told, a remark says
/// how many there are. Nothing where the image states none. Roots that rounding left undecided, and what an
/// irradiance cache set to zero, may all be right: they are a remark above the limit, and below it they could
/// change no verdict.
std::optional<GateResult> check_bad_samples(const image::Image& result, results::TargetRecord& record);

}  // namespace orbs::judge

#pragma once

#include "judge/gate_result.h"
#include "metrics/image_pair.h"
#include "metrics/metric.h"
#include "registry/gates.h"

namespace orbs::judge {

/// Whether an image that can get more samples meets the gate: Pass where the whole interval lies within the
/// limits, Fail where it lies wholly beyond, else Inconclusive with what it needs (GateResult::need). The
/// error rates hold over all looks of `pair` together; docs/understand/verdicts.md derives them. A PSNR is
/// judged without its noise. `measurement` has a value.
///
/// Two rules have no interval of that kind. A plain number (GateRule::Value), which noise makes worse, and
/// tests of what is certain of an error, in which noise may hide it: such a gate is missed as without looks,
/// but a number is no miss before the image has as many samples as its case asks for. `of_first_guess`: the
/// image's share of these.
GateResult check_gate_at_look(const registry::Gate& gate,
                              const metrics::Measurement& measurement,
                              const metrics::ImagePair& pair,
                              double of_first_guess);

}  // namespace orbs::judge

#pragma once

#include "metrics/image_pair.h"
#include "metrics/metric.h"
#include "registry/case.h"
#include "results/verdict.h"

#include <string>

namespace orbs::judge {

struct GateResult {
  results::Verdict verdict = results::Verdict::Pass;
  std::string reason;
  double excess =
      0;  // by which factor the limit is missed, of PSNRs the factor of the error; orders failures
};

/// Whether the measurement meets the gate, by the rule of its metric (metrics::GateRule): Pass, Fail, or
/// Inconclusive where noise does not let it be told, with how many times the samples are needed. `pair` is
/// what was measured; its noise decides where the rule is NoiseAware.
GateResult check_gate(const registry::Gate& gate,
                      const metrics::Measurement& measurement,
                      const metrics::ImagePair& pair);

/// InputError for a gate whose metric does not exist, with its place and the nearest name.
void refuse_unknown_metrics(const registry::Case& one_case);

}  // namespace orbs::judge

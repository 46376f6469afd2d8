#pragma once

#include "results/verdict.h"

#include <limits>
#include <optional>
#include <string>

namespace orbs::judge {

/// What a gate needs that is not decided yet, where the result can get more samples.
struct Need {
  static constexpr double kNever = std::numeric_limits<double>::infinity();
  double samples = kNever;  // times those of now, as it looks now
  double at_best =
      kNever;  // the same if the error is two standard errors nearer to, or farther from, the limit
  bool is_reference = false;  // no number of samples decides it, for the noise of the reference
  bool is_edge = false;       // the whole interval lies at 0.85 to 1.15 of the limit
  bool awaits_looks = false;  // by its pixels it is missed: more looks are to tell what they have in common
};

struct GateResult {
  results::Verdict verdict = results::Verdict::Pass;
  std::string reason;
  double excess =
      0;  // by which factor the limit is missed, of PSNRs the factor of the error; orders failures
  std::optional<Need> need = {};  // of a gate that is Inconclusive for want of samples
  std::string gate = {};          // its metric, and the interval that the decision rests on
  std::optional<double> value = {};
  std::optional<double> low = {};
  std::optional<double> high = {};
};

}  // namespace orbs::judge

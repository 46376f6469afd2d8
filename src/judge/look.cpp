#include "judge/look.h"

#include <algorithm>
#include <cmath>

namespace orbs::judge {

using results::Verdict;

namespace {

// Of a gate that passes: how near the interval comes to its limits.
double nearness(const GateResult& result) {
  return result.low && result.high ? std::max(std::fabs(*result.low), std::fabs(*result.high)) : 0;
}

}  // namespace

Verdict worst_of(const std::vector<GateResult>& results) {
  auto worst = results.front().verdict;
  for (const auto& result : results) worst = results::worse(worst, result.verdict);
  return worst;
}

Look look_at(const std::vector<GateResult>& results, const Looks& looks) {
  Look look;
  if (looks.most == 1 || results.empty()) return look;
  const auto worst = worst_of(results);
  look.is_open = worst == Verdict::Inconclusive;
  const auto rank = [&](const GateResult& result) {
    if (worst == Verdict::Inconclusive) return result.need ? result.need->samples : Need::kNever;
    return worst == Verdict::Pass ? nearness(result) : result.excess;
  };
  const GateResult* first = nullptr;
  for (const auto& result : results) {
    if (result.verdict != worst) continue;
    if (worst == Verdict::Inconclusive) {
      look.is_open = look.is_open && result.need.has_value();
      const auto need = result.need.value_or(Need{});
      look.need.at_best = std::max(look.need.at_best, need.at_best);
      look.need.is_reference = look.need.is_reference || need.is_reference;
    }
    if (first == nullptr || rank(result) > rank(*first)) first = &result;
  }
  if (worst == Verdict::Inconclusive && first->need) {
    look.need.samples = first->need->samples;
    look.need.is_edge = first->need->is_edge;
  }
  look.gate = *first;
  const bool awaits_looks = std::any_of(results.begin(), results.end(), [](const auto& result) {
    return result.need && result.need->awaits_looks;
  });
  // It is about to be called wrong: what its other gates would need to pass is idle.
  if (look.is_open && awaits_looks) look.need = {2, 1};
  return look;
}

Look opened_where_early(Look look, const Looks& looks, const results::TargetRecord& record) {
  if (looks.most == 1 || looks.of_first_guess >= 1) return look;
  if (record.verdict != Verdict::ConstantImage) return look;
  look.is_open = true;
  look.need = {1 / looks.of_first_guess, 1};
  return look;
}

}  // namespace orbs::judge

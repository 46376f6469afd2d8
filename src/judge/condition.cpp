#include "judge/condition.h"

#include <limits>

#include <fmt/format.h>

namespace orbs::judge {

std::optional<GateResult> check_condition(const registry::ConditionBound& bound,
                                          const results::JobCondition& condition,
                                          results::TargetRecord& record) {
  using results::Verdict;
  constexpr double kPercent = 100;
  if (condition.spp == 0) return std::nullopt;
  results::Check check{.what = kConditionCheck, .reason = "", .min = std::nullopt, .max = bound.most};
  if (!condition.problem.empty()) {
    check.reason = fmt::format("what rounding decides is not known: {}", condition.problem);
    check.decided = false;
    record.checks.push_back(check);
    return GateResult{Verdict::Inconclusive, check.reason};
  }
  record.measures.push_back(
      {kConditionCheck, condition.pixels, "1",
       fmt::format("mean of the absolute differences of single pixels between two renders of {} samples per "
                   "pixel with the same random numbers, in single and in double precision, over the mean of "
                   "the image; grey is the mean of R, G and B",
                   condition.spp),
       true});
  check.passed = condition.pixels <= bound.most;
  check.reason = fmt::format(
      "in double precision single pixels differ by {:.2g} % on average, at most {:.2g} % is allowed",
      kPercent * condition.pixels, kPercent * bound.most);
  if (!check.passed)
    check.reason +=
        fmt::format(": rounding decides what they show, most at ({}, {})", condition.x, condition.y);
  record.checks.push_back(check);
  if (check.passed) return std::nullopt;
  const double excess =
      bound.most > 0 ? condition.pixels / bound.most : std::numeric_limits<double>::infinity();
  return GateResult{Verdict::Fail, check.reason, excess};
}

}  // namespace orbs::judge

#include "studies/cost/numbers.h"

#include "studies/cost/comparisons.h"
#include "studies/cost/points.h"
#include "studies/cost/prices.h"

namespace orbs::studies {

namespace {

// A point is on the frontier when no other of its target is both cheaper and better.
void mark_frontier(const CostRecord& record, std::vector<CostCurve>& curves) {
  const auto target_of = [&](const CostCurve& curve) { return record.ladders[curve.ladder].target; };
  for (auto& curve : curves)
    for (auto& point : curve.points) {
      if (!point.errors[kRelmse]) continue;
      point.is_on_frontier = true;
      for (const auto& other : curves) {
        if (target_of(other) != target_of(curve)) continue;
        for (const auto& rival : other.points)
          if (rival.errors[kRelmse] && rival.cpu_seconds.value < point.cpu_seconds.value &&
              rival.errors[kRelmse]->value <= point.errors[kRelmse]->value)
            point.is_on_frontier = false;
      }
    }
}

}  // namespace

CostNumbers cost_numbers(const CostRecord& record) {
  CostNumbers numbers;
  for (std::size_t ladder = 0; ladder < record.ladders.size(); ++ladder) {
    auto curve = cost_curve(record, ladder);
    set_prices(curve, record.renderers.at(record.ladders[ladder].renderer).ladder == kSampleLadder);
    numbers.curves.push_back(std::move(curve));
  }
  mark_frontier(record, numbers.curves);
  numbers.self_comparison = compare_with_itself(record);
  if (numbers.self_comparison && numbers.self_comparison->passed)
    numbers.comparisons = compare_renderers(record, numbers.curves);
  return numbers;
}

}  // namespace orbs::studies

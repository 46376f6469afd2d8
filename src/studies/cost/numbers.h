#pragma once

#include "studies/cost/other_load.h"
#include "studies/cost/time_to_error.h"

#include <optional>
#include <vector>

/// What follows from the renders of a study of cost. It is written beside them for other readers and the
/// page, and computed anew whenever a study is read. A number that the renders do not give is missing.
namespace orbs::studies {

/// How the second of two renderers stands to the first.
enum class Ranking { Faster, Slower, NoDifferenceShown, NotComparable };

inline constexpr auto names(Ranking) {
  return std::array{json::Named{Ranking::Faster, "faster"}, json::Named{Ranking::Slower, "slower"},
                    json::Named{Ranking::NoDifferenceShown, "no difference shown"},
                    json::Named{Ranking::NotComparable, "not comparable"}};
}

struct CostComparison {
  std::size_t target = 0;
  ErrorTarget error;
  std::size_t first = 0, second = 0;   // renderers
  std::optional<Interval> time_ratio;  // CPU time of the second over that of the first at equal error
  Ranking ranking = Ranking::NotComparable;
};

template <class Visitor, json::RecordOf<CostComparison> Record>
void fields(Visitor& visit, Record& comparison) {
  visit("target", comparison.target);
  fields(visit, comparison.error);
  visit("first", comparison.first);
  visit("second", comparison.second);
  visit.nullable("time_ratio", comparison.time_ratio);
  visit("ranking", comparison.ranking);
}

/// A renderer under two names: no difference may be found.
struct SelfComparison {
  std::size_t renderer = 0, target = 0;
  int pairs = 0;
  Interval time_ratio, error_ratio;  // at 1 % outside
  bool is_known = false;             // both within a factor of two
  bool passed = false;
};

template <class Visitor, json::RecordOf<SelfComparison> Record>
void fields(Visitor& visit, Record& found) {
  visit("renderer", found.renderer);
  visit("target", found.target);
  visit("pairs", found.pairs);
  visit("time_ratio", found.time_ratio);
  visit("error_ratio", found.error_ratio);
  visit("known", found.is_known);
  visit("passed", found.passed);
}

struct CostNumbers {
  std::vector<CostCurve> curves;  // by sweep
  /// Only where the comparison of a renderer with itself passed.
  std::vector<CostComparison> comparisons;
  std::optional<SelfComparison> self_comparison;
  OtherLoad other_load;
};

template <class Visitor, json::RecordOf<CostNumbers> Record>
void fields(Visitor& visit, Record& numbers) {
  visit("curves", numbers.curves);
  visit("comparisons", numbers.comparisons);
  visit.nullable("self_comparison", numbers.self_comparison);
  visit("other_load", numbers.other_load);
}

CostNumbers cost_numbers(const CostRecord& record);

}  // namespace orbs::studies

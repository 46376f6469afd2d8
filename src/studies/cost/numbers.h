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

/// Two renderers at one error over all scenes. The page, the terminal and the reports show this and compute
/// nothing of their own.
struct MeanRatio {
  ErrorTarget error;
  std::size_t first = 0, second = 0;  // renderers
  int scenes = 0;                     // where both times are known
  Interval time_ratio;                // geometric mean over them of the second's time over the first's
};

template <class Visitor, json::RecordOf<MeanRatio> Record>
void fields(Visitor& visit, Record& mean) {
  fields(visit, mean.error);
  visit("first", mean.first);
  visit("second", mean.second);
  visit("scenes", mean.scenes);
  visit("time_ratio", mean.time_ratio);
}

/// A renderer and itself on one scene.
struct SelfScene {
  std::size_t target = 0;
  int pairs = 0;
  Interval time_ratio, error_ratio;  // at 1 % outside
};

template <class Visitor, json::RecordOf<SelfScene> Record>
void fields(Visitor& visit, Record& scene) {
  visit("target", scene.target);
  visit("pairs", scene.pairs);
  visit("time_ratio", scene.time_ratio);
  visit("error_ratio", scene.error_ratio);
}

/// A renderer under two names: no difference may be found.
struct SelfComparison {
  std::size_t renderer = 0;
  std::vector<SelfScene> scenes;
  Interval time_ratio,
      error_ratio;  // geometric means over the scenes, by the scatter of the seeds; 1 % outside
  Spread time_spread, error_spread;  // of the scenes' ratios
  /// The standard deviation over the scenes of the logarithm of the ratio: 0.02 is about 2 %. 0 of one scene.
  double time_scatter = 0, error_scatter = 0;
  int differing = 0;      // scenes that alone would show a difference
  bool is_known = false;  // both within a factor of two
  bool passed = false;
};

template <class Visitor, json::RecordOf<SelfComparison> Record>
void fields(Visitor& visit, Record& found) {
  visit("renderer", found.renderer);
  visit("scenes", found.scenes);
  visit("time_ratio", found.time_ratio);
  visit("error_ratio", found.error_ratio);
  visit("time_least", found.time_spread.least);
  visit("time_most", found.time_spread.most);
  visit("error_least", found.error_spread.least);
  visit("error_most", found.error_spread.most);
  visit("time_scatter", found.time_scatter);
  visit("error_scatter", found.error_scatter);
  visit("differing", found.differing);
  visit("known", found.is_known);
  visit("passed", found.passed);
}

struct CostNumbers {
  std::vector<CostCurve> curves;  // by sweep
  /// Only where the comparison of a renderer with itself passed.
  std::vector<CostComparison> comparisons;
  std::vector<MeanRatio> mean_ratios;
  std::optional<SelfComparison> self_comparison;
  OtherLoad other_load;
};

template <class Visitor, json::RecordOf<CostNumbers> Record>
void fields(Visitor& visit, Record& numbers) {
  visit("curves", numbers.curves);
  visit("comparisons", numbers.comparisons);
  visit("mean_ratios", numbers.mean_ratios);
  visit.nullable("self_comparison", numbers.self_comparison);
  visit("other_load", numbers.other_load);
}

/// The second's time over the first's, both exact.
LogRatio log_ratio_of(const TimeToError& first, const TimeToError& second);

/// The error in decibels, by its place in error_targets(), that is nearest the target of the study.
std::size_t main_error(const CostRecord& record);

CostNumbers cost_numbers(const CostRecord& measured);

}  // namespace orbs::studies

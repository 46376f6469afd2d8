#pragma once

#include "studies/confidence.h"
#include "studies/cost/error_fit.h"
#include "studies/cost/record.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What follows from the renders of a study of cost. Nothing is stored that can be computed anew, and a
/// number that the renders do not give is missing.
namespace orbs::studies {

struct CostMetric {
  std::string_view name;
  std::string_view unit;
  bool is_lower_better;
  bool is_log;
  std::string_view definition;
};

inline constexpr std::size_t kRelmse = 0, kMse = 1, kPsnr = 2, kFlip = 3;
inline constexpr std::array<CostMetric, 4> kCostMetrics{{
    {"relmse", "", true, true,
     "mean over R, G, B of all unmasked pixels of (result - reference)^2 / (reference^2 + 0.01), linear Rec.709; "
     "mean over the seeds, the noise of the reference subtracted by its variances"},
    {"mse", "radiance^2", true, true,
     "mean over R, G, B of all unmasked pixels of (result - reference)^2, linear Rec.709; mean over the seeds, "
     "the noise of the reference subtracted by its variances"},
    {"psnr_srgb8", "dB", false, false,
     "10 log10(255^2 / MSE) of the clamped sRGB values times 255; of the mean MSE over the seeds. The noise of "
     "the reference is in it"},
    {"flip", "", true, true, "mean LDR-FLIP error, mean over the seeds. The noise of the reference is in it"},
}};

struct CostPoint {
  std::size_t rung = 0;
  int renders = 0;
  Interval cpu_seconds, wall_seconds;  // medians
  std::optional<Interval> render_seconds;
  std::array<std::optional<Interval>, 4> errors;  // in the order of kCostMetrics
  bool is_below_reference_noise = false;          // the relmse is not twice what the reference's noise makes
  bool is_on_frontier = false;  // no other point of the target is cheaper and has less relmse
};

/// Goals of the prices: a level of a metric.
struct CostGoal {
  std::size_t metric;
  double level;
};

/// The CPU time to a goal, the fixed cost included. Of samples it is interpolated between two rungs, linear
/// in the logarithms of the error and of the time above the fixed cost; of settings, which have nothing in
/// between, it is that of the first rung that reaches the goal.
struct CostPrice {
  CostGoal goal;
  std::optional<Interval> cpu_seconds;
  std::string note;                // why there is no number: "not reached: more than 12.3 s"
  std::optional<double> at_least;  // a bound, where the goal is not reached
  double log_error = 0;            // standard error of the logarithm
  double degrees = 1;
};

struct CostCurve {
  std::size_t ladder = 0;
  Interval fixed_cpu_seconds;
  std::vector<CostPoint> points;  // by rung
  double relative_variance = 0;   // of the squared error of one image over its square, pooled over the rungs
  double degrees = 0;             // with which it is known
  std::optional<ErrorFit> fit;
  std::vector<CostPrice> prices;
  std::optional<Interval> efficiency;      // 1 / (relmse x CPU seconds)
  std::optional<Interval> seconds_per_db;  // the share of the time that one more decibel costs
};

struct CostComparison {
  std::size_t target = 0;
  CostGoal goal{};
  std::size_t first = 0, second = 0;   // renderers
  std::optional<Interval> time_ratio;  // CPU time of the second over that of the first at equal error
  std::string verdict;  // of the second: "cheaper", "dearer", "no difference shown", "not comparable"
  std::string note;
};

/// A renderer under two names: no difference may be found.
struct SelfComparison {
  std::size_t ladder = 0;
  int pairs = 0;
  Interval time_ratio, error_ratio;  // at 1 % outside
  bool is_known = false;             // both within a factor of two
  bool passed = false;
};

/// The goals: 30, 35, 40 and 45 dB, relmse 1e-2, 1e-3 and 1e-4.
const std::vector<CostGoal>& cost_goals();

/// "35 dB", "relMSE 1e-3".
std::string goal_text(const CostGoal& goal);

/// The mean squared error in steps of 1/255 that belongs to a PSNR.
double mse_of_psnr(double decibels);

}  // namespace orbs::studies

#pragma once

#include "studies/cost/error_fit.h"
#include "studies/cost/record.h"
#include "studies/seed_statistics.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The curve of a sweep: its error by its time.
namespace orbs::studies {

struct CostMetric {
  std::string_view name;
  std::string_view unit;
  bool is_lower_better = false;
  bool is_log = false;
  std::string_view definition;
};

template <class Visitor, json::RecordOf<CostMetric> Record>
void fields(Visitor& visit, Record& metric) {
  visit("name", metric.name);
  visit("unit", metric.unit);
  visit("lower_is_better", metric.is_lower_better);
  visit("log", metric.is_log);
}

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

/// By metric, in the order of kCostMetrics.
struct CostErrors : std::array<std::optional<Interval>, kCostMetrics.size()> {};

template <class Visitor, json::RecordOf<CostErrors> Record>
void fields(Visitor& visit, Record& errors) {
  for (std::size_t metric = 0; metric < errors.size(); ++metric)
    visit.nullable(kCostMetrics.at(metric).name, errors.at(metric));
}

/// What the renders of one setting say together.
struct CostPoint {
  SweepSetting setting;
  int renders = 0;
  Interval cpu_seconds, wall_seconds;                     // medians
  std::optional<Interval> render_seconds, trial_seconds;  // that the renderer states
  CostErrors errors;
  bool is_below_reference_noise = false;  // the relmse is not twice what the reference's noise makes
  bool is_on_frontier = false;            // no other point of the target is faster and has less relmse
  std::string image, exr;                 // the setting's first image, relative to the study's folder
};

template <class Visitor, json::RecordOf<CostPoint> Record>
void fields(Visitor& visit, Record& point) {
  visit("setting", point.setting.name);
  visit("spp", point.setting.spp);
  visit("renders", point.renders);
  visit("cpu_seconds", point.cpu_seconds);
  visit("wall_seconds", point.wall_seconds);
  visit.nullable("render_seconds", point.render_seconds);
  visit.nullable("trial_seconds", point.trial_seconds);
  visit("errors", point.errors);
  visit("below_reference_noise", point.is_below_reference_noise);
  visit("on_frontier", point.is_on_frontier);
  visit("image", point.image);
  visit("exr", point.exr);
}

/// An error that a renderer is to reach: a level of a metric.
struct ErrorTarget {
  std::size_t metric = 0;
  double level = 0;

  friend bool operator==(const ErrorTarget&, const ErrorTarget&) = default;
};

template <class Visitor, json::RecordOf<ErrorTarget> Record>
void fields(Visitor& visit, Record& target) {
  visit("metric", kCostMetrics.at(target.metric).name);
  visit("level", target.level);
}

/// What is known of a time to error.
enum class Bound {
  Exact,    // the time, with its interval
  AtMost,   // the first setting reaches the error
  AtLeast,  // no setting reaches it
  Unknown,  // not measured, or too short to be told from the fixed cost
};

inline constexpr auto names(Bound) {
  return std::array{json::Named{Bound::Exact, "exact"}, json::Named{Bound::AtMost, "at most"},
                    json::Named{Bound::AtLeast, "at least"}, json::Named{Bound::Unknown, "unknown"}};
}

/// The CPU time to an error, the fixed cost included. Of samples it is interpolated between two sample
/// counts, linear in the logarithms of the error and of the time above the fixed cost; of settings, which
/// have nothing in between, it is that of the first setting that reaches the error.
struct TimeToError {
  ErrorTarget target;
  Bound bound = Bound::Unknown;
  std::optional<Interval> cpu_seconds;  // if the bound is exact
  double bound_seconds = 0;             // if it is at most or at least
  double log_error = 0;                 // standard error of the logarithm
  double degrees = 1;
};

template <class Visitor, json::RecordOf<TimeToError> Record>
void fields(Visitor& visit, Record& time) {
  fields(visit, time.target);
  visit("bound", time.bound);
  visit.nullable("cpu_seconds", time.cpu_seconds);
  visit("bound_seconds", time.bound_seconds);
}

struct CostCurve {
  std::size_t sweep = 0;
  std::size_t target = 0, renderer = 0;       // those of the sweep
  std::optional<Interval> fixed_cpu_seconds;  // nothing if it was not measured
  std::vector<CostPoint> points;              // by setting
  double relative_variance = 0;  // of the squared error of one image over its square, pooled over the points
  double degrees = 0;            // with which it is known
  std::optional<ErrorFit> fit;
  std::vector<TimeToError> times_to_error;
  std::optional<Interval> efficiency;      // 1 / (relmse x CPU seconds)
  std::optional<Interval> seconds_per_db;  // the share of the time that one more decibel takes
  std::string note;                        // of the sweep
  std::string unmeasured;                  // what the budget left out
};

template <class Visitor, json::RecordOf<CostCurve> Record>
void fields(Visitor& visit, Record& curve) {
  visit("target", curve.target);
  visit("renderer", curve.renderer);
  visit.nullable("fixed_cpu_seconds", curve.fixed_cpu_seconds);
  visit("points", curve.points);
  visit.nullable("fit", curve.fit);
  visit("times_to_error", curve.times_to_error);
  visit.nullable("efficiency", curve.efficiency);
  visit.nullable("seconds_per_db", curve.seconds_per_db);
  visit("note", curve.note);
  visit("unmeasured", curve.unmeasured);
}

/// The renders of a sweep that were made for `purpose`; of one setting where `setting` names one. Those that
/// other work on the machine disturbed are left out where others are there.
std::vector<const CostRender*> renders_of(const CostRecord& record,
                                          const Sweep& sweep,
                                          Purpose purpose,
                                          const std::string& setting = "");

/// The curve of the sweep with this index: its points, its noise and its fit. Its times to error and the
/// frontier are missing still.
CostCurve cost_curve(const CostRecord& record, std::size_t index);

/// CPU seconds of the fixed cost; 0 if it was not measured.
double fixed_seconds(const CostCurve& curve);

/// The point's median CPU time above the fixed cost; nothing where it is not above it.
std::optional<double> seconds_above_fixed(const CostCurve& curve, const CostPoint& point);

/// The mean squared error in steps of 1/255 that belongs to a PSNR.
double mse_of_psnr(double decibels);

/// The image of the first seed of a setting, relative to the study's folder; `ending`: "exr" or "png".
std::string image_file(const CostRecord& record, const Sweep& sweep, std::size_t setting, const char* ending);

}  // namespace orbs::studies

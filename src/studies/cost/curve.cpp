#include "studies/cost/curve.h"

#include "studies/cost/other_load.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

using Member = std::optional<double> CostRender::*;
constexpr std::array<Member, 4> kMembers{&CostRender::relmse, &CostRender::mse, &CostRender::psnr_srgb8,
                                         &CostRender::flip};

std::vector<double> values_of(const std::vector<const CostRender*>& renders, Member member) {
  std::vector<double> values;
  for (const auto* render : renders)
    if (render->*member) values.push_back(*(render->*member));
  return values;
}

std::vector<double> seconds_of(const std::vector<const CostRender*>& renders, double CostRender::*member) {
  std::vector<double> values;
  for (const auto* render : renders) values.push_back(render->*member);
  return values;
}

Interval less(Interval interval, double amount) {
  return {interval.value - amount, interval.low - amount, interval.high - amount};
}

// The decibels of the mean of the squared errors, not the mean of the decibels.
std::optional<Interval> psnr_interval(const std::vector<double>& decibels) {
  std::vector<double> errors;
  for (const double value : decibels) errors.push_back(mse_of_psnr(value));
  const auto mean = mean_interval(errors);
  if (!(mean.value > 0)) return std::nullopt;  // equal images: infinite
  const auto psnr = [](double mse) { return 10 * std::log10(255 * 255 / mse); };
  // A mean square whose interval reaches zero leaves the PSNR without an upper end: it then ends at four
  // times the error, as low as the lower one.
  const double low = mean.low > 0 ? mean.low : mean.value / 4;
  return Interval{psnr(mean.value), psnr(mean.high), psnr(low)};
}

CostErrors errors_of(const std::vector<const CostRender*>& renders, const ReferenceNoise& noise) {
  CostErrors errors;
  for (std::size_t metric = 0; metric < kMembers.size(); ++metric) {
    const auto values = values_of(renders, kMembers.at(metric));
    if (values.empty()) continue;
    errors.at(metric) = metric == kPsnr ? psnr_interval(values) : mean_interval(values);
  }
  if (errors[kRelmse]) errors[kRelmse] = less(*errors[kRelmse], noise.relmse);
  if (errors[kMse]) errors[kMse] = less(*errors[kMse], noise.mse);
  return errors;
}

CostPoint point_of(const std::vector<const CostRender*>& renders,
                   const SweepSetting& setting,
                   const ReferenceNoise& noise) {
  CostPoint point;
  point.setting = setting;
  point.renders = static_cast<int>(renders.size());
  point.cpu_seconds = median_interval(seconds_of(renders, &CostRender::cpu_seconds));
  point.wall_seconds = median_interval(seconds_of(renders, &CostRender::wall_seconds));
  const auto stated = values_of(renders, &CostRender::render_seconds);
  if (stated.size() == renders.size()) point.render_seconds = median_interval(stated);
  const auto tried = values_of(renders, &CostRender::trial_seconds);
  if (tried.size() == renders.size()) point.trial_seconds = median_interval(tried);
  point.errors = errors_of(renders, noise);
  point.is_below_reference_noise = point.errors[kRelmse] && point.errors[kRelmse]->value < noise.relmse;
  return point;
}

// The squared errors of images of one setting have about the same relative scatter at every setting, so all
// settings together say it with more certainty than each alone.
void pool_noise(const CostRecord& record, CostCurve& curve) {
  double weighted = 0;
  for (const auto& point : curve.points) {
    const auto& sweep = record.sweeps[curve.sweep];
    const auto renders = renders_of(record, sweep, Purpose::Sweep, point.setting.name);
    const auto sample = sample_of(values_of(renders, &CostRender::relmse));
    if (sample.count < 2 || !(sample.mean > 0)) continue;
    weighted += (sample.count - 1) * sample.variance / (sample.mean * sample.mean);
    curve.degrees += sample.count - 1;
  }
  if (curve.degrees > 0) curve.relative_variance = weighted / curve.degrees;
}

// Seconds of CPU time that one sample per pixel takes: of all settings together, so that mostly the last
// ones, whose times are least noisy, decide.
double seconds_per_spp(const CostCurve& curve) {
  double seconds = 0;
  double samples = 0;
  for (const auto& point : curve.points) {
    seconds += point.cpu_seconds.value - fixed_seconds(curve);
    samples += point.setting.spp;
  }
  return samples > 0 ? seconds / samples : 0;
}

// The samples of a setting are known exactly and its time is not. So the times of the fit are those that the
// samples take at the renderer's mean rate: noise of single times would pass for a bend of the curve.
void fit_curve(const Sweep& sweep, const ReferenceNoise& noise, CostCurve& curve) {
  const double rate = seconds_per_spp(curve);
  if (!(curve.relative_variance > 0) || !(rate > 0)) return;
  std::vector<FitPoint> points;
  for (const auto& point : curve.points)
    if (point.errors[kRelmse])
      points.push_back({rate * point.setting.spp, point.errors[kRelmse]->value, noise.relmse,
                        curve.relative_variance / point.renders});
  curve.fit = fit_error(points, curve.degrees);
  constexpr double kFloorShare = 3;
  // A curve that has not begun to flatten may only be bent: low-discrepancy samples converge faster at some
  // counts than at others.
  if (curve.fit && !points.empty() && curve.fit->bias_squared.value < points.back().error / kFloorShare)
    curve.fit->has_floor = false;
  if (curve.fit && curve.fit->has_floor) curve.fit->floor_named = sweep.finding;
}

}  // namespace

double mse_of_psnr(double decibels) { return 255 * 255 * std::pow(10, -decibels / 10); }

std::string image_file(const CostRecord& record,
                       const Sweep& sweep,
                       std::size_t setting,
                       const char* ending) {
  return fmt::format("images/{}/{}/{}.{}", record.renderers[sweep.renderer].name,
                     record.targets[sweep.target].name, setting, ending);
}

std::vector<const CostRender*> renders_of(const CostRecord& record,
                                          const Sweep& sweep,
                                          Purpose purpose,
                                          const std::string& setting) {
  std::vector<const CostRender*> renders;
  for (const auto& render : record.renders)
    if (render.target == sweep.target && render.renderer == sweep.renderer && render.purpose == purpose &&
        (setting.empty() || render.setting == setting))
      renders.push_back(&render);
  return that_count(std::move(renders));
}

double fixed_seconds(const CostCurve& curve) { return curve.fixed_cpu_seconds.value_or(Interval{}).value; }

std::optional<double> seconds_above_fixed(const CostCurve& curve, const CostPoint& point) {
  const double seconds = point.cpu_seconds.value - fixed_seconds(curve);
  return seconds > 0 ? std::optional(seconds) : std::nullopt;
}

CostCurve cost_curve(const CostRecord& record, std::size_t index) {
  const auto& sweep = record.sweeps[index];
  const auto& noise = record.targets.at(sweep.target).reference_noise;
  CostCurve curve;
  curve.sweep = index;
  curve.target = sweep.target;
  curve.renderer = sweep.renderer;
  curve.note = sweep.note;
  const auto fixed = renders_of(record, sweep, Purpose::FixedCost);
  if (!fixed.empty()) curve.fixed_cpu_seconds = median_interval(seconds_of(fixed, &CostRender::cpu_seconds));
  for (std::size_t i = 0; i < sweep.settings.size(); ++i) {
    const auto renders = renders_of(record, sweep, Purpose::Sweep, sweep.settings[i].name);
    if (renders.empty()) continue;
    curve.points.push_back(point_of(renders, sweep.settings[i], noise));
    curve.points.back().image = image_file(record, sweep, i, "png");
    curve.points.back().exr = image_file(record, sweep, i, "exr");
  }
  pool_noise(record, curve);
  if (record.renderers.at(sweep.renderer).sweep == SweepOf::Samples) fit_curve(sweep, noise, curve);
  return curve;
}

}  // namespace orbs::studies

#include "runner/judge.h"

#include "base/error.h"
#include "base/text.h"
#include "metrics/noise_numbers.h"
#include "runner/gate.h"
#include "runner/noise.h"
#include "runner/provenance.h"
#include "runner/tolerances.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::runner {

namespace {

using registry::Case;
using results::Check;
using results::TargetRecord;
using results::Verdict;

std::array<double, 3> mean_of_region(const image::Image& image, const registry::Rectangle& region) {
  std::array<double, 3> sum{};
  const std::array<int, 3> channels{image::channel_index(image, "R"), image::channel_index(image, "G"),
                                    image::channel_index(image, "B")};
  for (int y = region[1]; y < region[3]; ++y)
    for (int x = region[0]; x < region[2]; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        sum.at(c) += static_cast<double>(image.at(x, y, static_cast<std::size_t>(channels.at(c))));
  const double count = static_cast<double>(region[2] - region[0]) * (region[3] - region[1]);
  for (auto& value : sum) value /= count;
  return sum;
}

Check check_pixels(const registry::PixelCheck& check, const image::Image& image) {
  const auto mean = mean_of_region(image, check.region);
  Check out{fmt::format("pixels [{}]", fmt::join(check.region, ",")), true, "", {}, {}};
  for (std::size_t c = 0; c < 3; ++c)
    out.passed = out.passed && std::fabs(mean.at(c) - check.expected.at(c)) <= check.tolerance;
  out.reason =
      fmt::format("{} have the linear mean ({:.6g}), expected ({:.6g}) within {} ({})", out.what,
                  fmt::join(mean, ", "), fmt::join(check.expected, ", "), check.tolerance, check.why);
  return out;
}

Check check_share(const registry::PathShare& share, const std::map<std::string, std::string>& provenance) {
  Check out{fmt::format("paths {}", share.path_class), false, "", share.min_share, {}};
  const auto found = provenance.find("path." + share.path_class);
  const auto value = found == provenance.end() ? std::nullopt : to_number(found->second);
  out.passed = value && *value >= share.min_share;
  out.reason =
      value ? fmt::format("{} carry {:.3g} of the reference's light, at least {} is needed", out.what, *value,
                          share.min_share)
            : fmt::format("the reference's provenance does not say what {} carry; render it again", out.what);
  return out;
}

void add_measures(const metrics::Comparison& comparison,
                  const metrics::NoiseTest& noise,
                  TargetRecord& record) {
  for (const auto& [metric, value, where] : comparison.measurements)
    if (value)
      record.measures.push_back({std::string(metric->name),
                                 *value,
                                 std::string(metric->unit),
                                 std::string(metric->definition),
                                 metric->lower_is_better,
                                 false,
                                 {},
                                 {},
                                 rectangle_numbers(where)});
  for (const auto& number : metrics::noise_numbers(noise))
    record.measures.push_back({std::string(number.name), number.value, std::string(number.unit),
                               std::string(number.definition), true, number.is_signed, number.low,
                               number.high, rectangle_numbers(number.where)});
}

void check_conditions(const Case& one_case, const image::Image& result, TargetRecord& record) {
  for (const auto& pixels : one_case.pixel_checks) {
    if (pixels.target != record.target) continue;
    record.checks.push_back(check_pixels(pixels, result));
    if (!record.checks.back().passed) take(record, Verdict::Fail, record.checks.back().reason);
  }
  for (const auto& share : one_case.path_shares) {
    if (share.scene != record.target) continue;
    record.checks.push_back(check_share(share, record.reference_provenance));
    // Not the renderer's fault: the case does not show what it is about.
    if (!record.checks.back().passed) take(record, Verdict::Inconclusive, record.checks.back().reason);
  }
}

}  // namespace

metrics::Mask mask_of(const Case& one_case, const std::string& image) {
  metrics::Mask mask;
  for (const auto& one : one_case.masks) {
    if (one.target != image) continue;
    for (const auto& r : one.rectangles) mask.rectangles.push_back({r[0], r[1], r[2], r[3]});
  }
  return mask;
}

std::optional<metrics::Comparison> judge(const Case& one_case,
                                         const image::Image& result,
                                         const Reference& reference,
                                         const JudgeSettings& settings,
                                         TargetRecord& record) {
  record.reference = reference.file.string();
  if (!reference.image) {
    take(record, Verdict::MissingReference, reference.problem);
    return std::nullopt;
  }
  if (const auto problem = variance_problem(result); !problem.empty()) {
    record.remarks.push_back(fmt::format("{}: its variances are not used", problem));
    return judge(one_case, without_variances(result), reference, settings, record);
  }
  record.reference_provenance = provenance_of(*reference.image);
  const auto is_name = [&](const auto& difference) { return difference.name == record.target; };
  const bool is_difference = std::any_of(one_case.differences.begin(), one_case.differences.end(), is_name);
  const auto mask = mask_of(one_case, record.target);
  const bool may_be_negative = is_difference || !one_case.negative_values.empty();
  const auto negatives =
      may_be_negative ? metrics::NegativePixels::Allowed : metrics::NegativePixels::Refused;
  auto comparison = metrics::compare(result, *reference.image, mask,
                                     {.negatives = negatives,
                                      .threads = settings.threads,
                                      .no_others = settings.measured == Measured::ForTheVerdict,
                                      .also = {one_case.gate.metric}});
  if (comparison.alignment.alignment != metrics::Alignment::Comparable) {
    // The result was looked at before, so this is about the reference.
    take(record, Verdict::MissingReference,
         fmt::format("the reference cannot be used: {}", comparison.alignment.reason));
    return std::nullopt;
  }
  const auto noise = metrics::test_noise(result, *reference.image, mask, settings.result_noise);
  add_measures(comparison, noise, record);
  if (auto remark = metrics::bias_remark(noise); !remark.empty()) record.remarks.push_back(std::move(remark));
  const auto gate = check_gate(one_case.gate, metrics::value_of(comparison, one_case.gate.metric),
                               gate_noise(result, *reference.image, mask, noise));
  record.checks.push_back({one_case.gate.metric, gate.verdict == Verdict::Pass, gate.reason,
                           one_case.gate.min, one_case.gate.max});
  take(record, gate.verdict, gate.reason);
  check_tolerances(one_case, {result, *reference.image, mask, noise}, record);
  check_conditions(one_case, result, record);
  return comparison;
}

}  // namespace orbs::runner

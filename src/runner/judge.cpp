#include "runner/judge.h"

#include "base/error.h"
#include "base/text.h"
#include "metrics/table.h"
#include "runner/noise.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::runner {

namespace {

using registry::Case;
using results::Check;
using results::PictureRecord;
using results::Verdict;

std::string number_text(double value, const std::string& unit) {
  return std::isinf(value)
             ? "infinite"
             : fmt::format("{:.4g}{}{}", value, unit == "1" ? "" : " ", unit == "1" ? "" : unit);
}

// With half a dB to spare for what the delta method leaves out.
constexpr double kNoiseSlack_db = 0.5;

// The PSNR that the noise of both pictures alone lets expect; nothing where neither knows its noise.
std::optional<double> noise_psnr(const image::Image& result,
                                 const image::Image& reference,
                                 const metrics::Mask& mask) {
  const auto of_result = noise_mse_srgb8(result, reference, mask);
  const auto of_reference = noise_mse_srgb8(reference, reference, mask);
  if (!of_result && !of_reference) return std::nullopt;
  return psnr_srgb8_of(of_result.value_or(0) + of_reference.value_or(0));
}

struct GateResult {
  Verdict verdict = Verdict::Pass;
  std::string sentence;
};

GateResult check_gate(const registry::Gate& gate,
                      std::optional<double> value,
                      std::optional<double> noise_db) {
  if (!value) return {Verdict::Inconclusive, fmt::format("{} has no value for this picture", gate.metric)};
  const std::string unit(metrics::find_metric(gate.metric).unit);
  const auto is = fmt::format("{} is {}", gate.metric, number_text(*value, unit));
  if (gate.min && !(*value >= *gate.min)) {
    // A right picture with this noise would measure the same, so the gate cannot tell the two apart.
    if (gate.metric == "psnr_srgb8" && noise_db && *value >= *noise_db - kNoiseSlack_db)
      return {Verdict::Inconclusive,
              fmt::format("{}, at least {} is needed, but noise alone gives {}: more samples are needed", is,
                          *gate.min, number_text(*noise_db, unit))};
    return {Verdict::Fail, fmt::format("{}, at least {} is needed", is, *gate.min)};
  }
  if (gate.max && !(*value <= *gate.max))
    return {Verdict::Fail, fmt::format("{}, at most {} is allowed", is, *gate.max)};
  return {Verdict::Pass, is};
}

std::array<double, 3> mean_of_region(const image::Image& picture, const registry::Rectangle& region) {
  std::array<double, 3> sum{};
  const std::array<int, 3> channels{image::channel_index(picture, "R"), image::channel_index(picture, "G"),
                                    image::channel_index(picture, "B")};
  for (int y = region[1]; y < region[3]; ++y)
    for (int x = region[0]; x < region[2]; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        sum.at(c) += static_cast<double>(picture.at(x, y, static_cast<std::size_t>(channels.at(c))));
  const double count = static_cast<double>(region[2] - region[0]) * (region[3] - region[1]);
  for (auto& value : sum) value /= count;
  return sum;
}

Check check_pixels(const registry::PixelCheck& check, const image::Image& picture) {
  const auto mean = mean_of_region(picture, check.region);
  Check out{fmt::format("pixels [{}]", fmt::join(check.region, ",")), true, "", {}, {}};
  for (std::size_t c = 0; c < 3; ++c)
    out.passed = out.passed && std::fabs(mean.at(c) - check.expected.at(c)) <= check.tolerance;
  out.sentence =
      fmt::format("{} have the linear mean ({:.6g}), expected ({:.6g}) within {} ({})", out.what,
                  fmt::join(mean, ", "), fmt::join(check.expected, ", "), check.tolerance, check.why);
  return out;
}

Check check_share(const registry::PathShare& share, const std::map<std::string, std::string>& passport) {
  Check out{fmt::format("paths {}", share.path_class), false, "", share.min_share, {}};
  const auto found = passport.find("path." + share.path_class);
  const auto value = found == passport.end() ? std::nullopt : to_number(found->second);
  out.passed = value && *value >= share.min_share;
  out.sentence =
      value ? fmt::format("{} carry {:.3g} of the reference's light, at least {} is needed", out.what, *value,
                          share.min_share)
            : fmt::format("the reference's passport does not say what {} carry; render it again", out.what);
  return out;
}

void add_measures(const metrics::Comparison& comparison, PictureRecord& record) {
  for (const auto& measurement : comparison.measurements)
    if (measurement.value)
      record.measures.push_back(
          {std::string(measurement.metric->name), *measurement.value, std::string(measurement.metric->unit),
           std::string(measurement.metric->definition), measurement.metric->lower_is_better});
}

// A worse verdict takes over, with its sentence.
void take(PictureRecord& record, Verdict verdict, const std::string& sentence) {
  if (record.verdict == Verdict::Skipped || results::worse(verdict, record.verdict) != record.verdict) {
    record.verdict = verdict;
    record.sentence = sentence;
  }
}

void check_conditions(const Case& one_case, const image::Image& result, PictureRecord& record) {
  for (const auto& pixels : one_case.pixel_checks) {
    if (pixels.picture != record.picture) continue;
    record.checks.push_back(check_pixels(pixels, result));
    if (!record.checks.back().passed) take(record, Verdict::Fail, record.checks.back().sentence);
  }
  for (const auto& share : one_case.path_shares) {
    if (share.scene != record.picture) continue;
    record.checks.push_back(check_share(share, record.reference_passport));
    // Not the renderer's fault: the case does not show what it is about.
    if (!record.checks.back().passed) take(record, Verdict::Inconclusive, record.checks.back().sentence);
  }
}

}  // namespace

metrics::Mask mask_of(const Case& one_case, const std::string& picture) {
  metrics::Mask mask;
  for (const auto& one : one_case.masks) {
    if (one.picture != picture) continue;
    for (const auto& r : one.rectangles) mask.rectangles.push_back({r[0], r[1], r[2], r[3]});
  }
  return mask;
}

std::map<std::string, std::string> passport_of(const image::Image& picture) {
  constexpr std::string_view kPrefix = "orbs.";
  std::map<std::string, std::string> passport;
  for (const auto& [name, text] : picture.attributes)
    if (name.starts_with(kPrefix)) passport[name.substr(kPrefix.size())] = text;
  return passport;
}

std::optional<metrics::Comparison> judge(const Case& one_case,
                                         const image::Image& result,
                                         const Reference& reference,
                                         int threads,
                                         PictureRecord& record) {
  record.reference = reference.file.string();
  if (!reference.picture) {
    take(record, Verdict::MissingReference, reference.problem);
    return std::nullopt;
  }
  record.reference_passport = passport_of(*reference.picture);
  const auto is_name = [&](const auto& difference) { return difference.name == record.picture; };
  const bool is_difference = std::any_of(one_case.differences.begin(), one_case.differences.end(), is_name);
  const auto mask = mask_of(one_case, record.picture);
  const bool may_be_negative = is_difference || !one_case.negative_values.empty();
  const auto negatives =
      may_be_negative ? metrics::NegativePixels::Allowed : metrics::NegativePixels::Refused;
  auto comparison = metrics::compare(result, *reference.picture, mask, {negatives, threads});
  if (comparison.alignment.alignment != metrics::Alignment::Comparable) {
    // The result was looked at before, so this is about the reference.
    take(record, Verdict::MissingReference,
         fmt::format("the reference cannot be used: {}", comparison.alignment.sentence));
    return std::nullopt;
  }
  add_measures(comparison, record);
  const auto gate = check_gate(one_case.gate, metrics::value_of(comparison, one_case.gate.metric),
                               noise_psnr(result, *reference.picture, mask));
  record.checks.push_back({one_case.gate.metric, gate.verdict == Verdict::Pass, gate.sentence,
                           one_case.gate.min, one_case.gate.max});
  take(record, gate.verdict, gate.sentence);
  check_conditions(one_case, result, record);
  return comparison;
}

}  // namespace orbs::runner

#include "judge/judge.h"

#include "base/statistics.h"
#include "base/text.h"
#include "judge/bad_samples.h"
#include "judge/condition.h"
#include "judge/exact_copy.h"
#include "judge/gate.h"
#include "judge/noise.h"
#include "judge/provenance.h"
#include "metrics/describe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::judge {

namespace {

using registry::Case;
using results::Check;
using results::TargetRecord;
using results::Verdict;

// A worse verdict takes over, with its reason.
void take(TargetRecord& record, Verdict verdict, const std::string& reason) {
  if (record.verdict == Verdict::Skipped || results::worse(verdict, record.verdict) != record.verdict) {
    record.verdict = verdict;
    record.reason = reason;
  }
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

std::vector<double> rectangle_numbers(const std::optional<Rectangle>& where) {
  if (!where) return {};
  return {static_cast<double>(where->x0), static_cast<double>(where->y0), static_cast<double>(where->x1),
          static_cast<double>(where->y1)};
}

void add_measures(const metrics::Comparison& comparison, TargetRecord& record) {
  for (const auto& measurement : comparison.measurements) {
    if (!measurement.value) continue;
    const auto& metric = *measurement.metric;
    record.measures.push_back({std::string(metric.name), *measurement.value, std::string(metric.unit),
                               std::string(metric.definition), metric.better != metrics::Better::Higher,
                               metric.better == metrics::Better::NearZero, measurement.low, measurement.high,
                               rectangle_numbers(measurement.where)});
  }
}

std::vector<GateResult> check_gates(const Case& one_case,
                                    const metrics::ImagePair& pair,
                                    const metrics::Comparison& comparison,
                                    double of_first_guess,
                                    TargetRecord& record) {
  std::vector<GateResult> results;
  for (const auto& gate : one_case.gates) {
    const auto result =
        check_gate(gate, *metrics::find_measurement(comparison, gate.metric), pair, of_first_guess);
    record.checks.push_back({.what = gate.metric,
                             .passed = result.verdict == Verdict::Pass,
                             .reason = result.reason,
                             .min = gate.min,
                             .max = gate.max,
                             .decided = result.verdict != Verdict::Inconclusive});
    if (pair.looks > 1 && result.low && gate.metric == "psnr_srgb8")
      record.measures.push_back(
          {std::string(results::kPsnrWithoutNoise), *result.low, "dB",
           "PSNR that is certain of the image without its noise: that of the product of the "
           "errors of two halves of its samples, and the reach of that; as psnr_srgb8"});
    results.push_back(result);
  }
  return results;
}

// A check of several standard errors is made at every look, so each of them gets its share of what these
// leave out. One without is missed by noise, too, until the image has the samples that its case asks for.
void check_pixels_at_look(registry::PixelCheck pixels,
                          const image::Image& result,
                          const Looks& looks,
                          TargetRecord& record,
                          std::vector<GateResult>& results) {
  constexpr double kNormal = 1e9;  // degrees of freedom
  if (looks.most > 1 && pixels.standard_errors > 0)
    pixels.standard_errors =
        student_quantile(student_tail(pixels.standard_errors, kNormal) / looks.most, kNormal);
  record.checks.push_back(check_pixels(pixels, result));
  auto& check = record.checks.back();
  if (!check.measured || check.passed) return;
  GateResult missed{verdict_of_missed_check(pixels, result), check.reason,
                    excess_of_missed_check(pixels, result)};
  const bool is_early = looks.most > 1 && looks.of_first_guess < 1;
  if (is_early && pixels.standard_errors == 0) missed.verdict = Verdict::Inconclusive;
  if (looks.most > 1 && missed.verdict == Verdict::Inconclusive) missed.need = Need{2, 1};
  results.push_back(std::move(missed));
}

std::vector<GateResult> check_conditions(const Case& one_case,
                                         const image::Image& result,
                                         const JudgeSettings& settings,
                                         TargetRecord& record) {
  const auto& looks = settings.looks;
  std::vector<GateResult> results;
  for (const auto& pixels : one_case.pixel_checks)
    if (pixels.target == record.target) check_pixels_at_look(pixels, result, looks, record, results);
  for (const auto& share : one_case.path_shares) {
    if (share.scene != record.target) continue;
    record.checks.push_back(check_share(share, record.reference_provenance));
    // Not the renderer's fault: the case does not show what it is about.
    if (!record.checks.back().passed) results.push_back({Verdict::Inconclusive, record.checks.back().reason});
  }
  if (one_case.condition)
    if (auto missed = check_condition(*one_case.condition, settings.condition, record))
      results.push_back(std::move(*missed));
  if (auto refused = check_bad_samples(result, record)) {
    // One in few is no share yet.
    if (looks.most > 1 && looks.of_first_guess < 1) {
      refused->verdict = Verdict::Inconclusive;
      refused->need = Need{2, 1};
    }
    results.push_back(std::move(*refused));
  }
  return results;
}

// The worst verdict, with the reasons of all results that have it, the farthest from its limit first. The
// reason of a pass is that of the first gate.
void take_worst(std::vector<GateResult> results, TargetRecord& record) {
  if (results.empty()) return;
  const auto worst = worst_of(results);
  if (worst == Verdict::Pass) {
    take(record, worst, results.front().reason);
    return;
  }
  std::erase_if(results, [&](const auto& result) { return result.verdict != worst; });
  std::stable_sort(results.begin(), results.end(),
                   [](const auto& a, const auto& b) { return a.excess > b.excess; });
  std::vector<std::string> reasons;
  for (const auto& result : results) reasons.push_back(result.reason);
  take(record, worst, fmt::format("{}", fmt::join(reasons, "; ")));
}

metrics::NegativePixels negatives_of(const Case& one_case, const std::string& target) {
  return is_difference(one_case, target) || !one_case.negative_values.empty()
             ? metrics::NegativePixels::Allowed
             : metrics::NegativePixels::Refused;
}

// Whether a negative pixel makes the image invalid. Another case may allow what this one does not, so each
// case is asked. Counts them where they are allowed.
bool refuse_negative(const Case& one_case, const metrics::PixelFaults& faults, TargetRecord& record) {
  if (is_difference(one_case, record.target) || faults.negative == 0) return false;
  if (one_case.negative_values.empty()) {
    record.verdict = Verdict::InvalidPixels;
    record.reason = fmt::format("{} pixels are negative, which its case does not allow; the first is {}",
                                faults.negative, faults.first);
    return true;
  }
  record.measures.push_back(
      {"negative_pixels", static_cast<double>(faults.negative), "1",
       fmt::format("pixels with a negative R, G or B, allowed here: {}", one_case.negative_values), true});
  return false;
}

// Where a Stokes parameter is no number; "" if all are, or there are none. No gate could measure them.
std::string stokes_problem(const image::Image& image) {
  if (!metrics::has_stokes(image)) return "";
  for (const char* layer : {"S1.", "S2.", "S3."})
    for (const char* colour : {"R", "G", "B"}) {
      const auto name = std::string(layer) + colour;
      const int channel = image::channel_index(image, name);
      if (channel < 0) continue;
      for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
          if (const float value = image.at(x, y, static_cast<std::size_t>(channel)); !std::isfinite(value))
            return fmt::format("{} is {} at pixel ({}, {})", name, value, x, y);
    }
  return "";
}

bool is_constant(const std::vector<float>& rgb) {
  for (std::size_t i = 3; i < rgb.size(); ++i)
    if (rgb[i] != rgb[i - 3]) return false;
  return true;
}

// A renderer that found no light or no scene leaves one colour all over, and a small or dark image may pass
// its gates all the same.
void refuse_constant(const metrics::ImagePair& pair, TargetRecord& record) {
  if (is_constant(pair.result) && !is_constant(pair.reference))
    take(record, Verdict::ConstantImage, "every pixel has the same colour, which the reference's have not");
}

// No image that was rendered can share the noise of another one. This says nothing of how good it is.
void refuse_copy(const metrics::ImagePair& pair, TargetRecord& record) {
  if (pair.noise.stated == metrics::StatedNoise::NearerThanReference) {
    take(
        record, Verdict::Fail,
        "it is nearer to the reference than the reference's own noise allows: it is a copy of it, or was rendered "
        "with its seed");
  } else if (metrics::holds_reference_noise(pair.noise)) {
    constexpr double kPercent = 100;
    const auto& [share, low, high] = *pair.noise.shared_noise;
    take(record, Verdict::Fail,
         fmt::format(
             "it holds {:.2g} % ({:.2g} to {:.2g} %) of the reference's own noise, which no other render "
             "has: it was made from the reference's pixels, or with its seed",
             kPercent * share, kPercent * low, kPercent * high));
  } else if (is_copy_of_exact_reference(pair)) {
    take(
        record, Verdict::Fail,
        "it equals the reference, which was computed and has no noise, in every pixel and to the last digits: an "
        "image of random samples cannot, so it is a copy; the entry of a renderer that draws none says \"noise_free\": "
        "true");
  }
}

std::vector<std::string> gate_metrics(const Case& one_case) {
  std::vector<std::string> names;
  for (const auto& gate : one_case.gates) names.push_back(gate.metric);
  return names;
}

// The same where checks alone judge: one colour where they expect several, or no light at all where they
// expect some, is no noise, and variances that the image states excuse nothing.
void refuse_constant_by_checks(const Case& one_case, const image::Image& result, TargetRecord& record) {
  const auto colours = image::select_rgb(result, "");
  if (!is_constant(colours.pixels)) return;
  const bool is_black = colours.pixels[0] == 0 && colours.pixels[1] == 0 && colours.pixels[2] == 0;
  const std::array<double, 3> no_light{};
  const registry::PixelCheck* first = nullptr;
  for (const auto& check : one_case.pixel_checks) {
    if (check.target != record.target || !check.not_measured.empty()) continue;
    if (first == nullptr) first = &check;
    if (check.expected != first->expected)
      take(record, Verdict::ConstantImage, "every pixel has the same colour, and the checks expect several");
    else if (is_black && check.expected != no_light)
      take(record, Verdict::ConstantImage, "every pixel is black, and the checks expect light");
  }
}

// Where no reference is meant to be, the checks decide: all that can be measured must pass, and one must be.
Look judge_by_checks(const Case& one_case,
                     const image::Image& result,
                     const JudgeSettings& settings,
                     TargetRecord& record) {
  const auto& looks = settings.looks;
  if (refuse_negative(one_case, metrics::count_faults(result, negatives_of(one_case, record.target)), record))
    return {};
  auto checked = check_conditions(one_case, result, settings, record);
  auto look = look_at(checked, looks);
  take_worst(std::move(checked), record);
  refuse_constant_by_checks(one_case, result, record);
  // How much rounding decides says nothing of what is right.
  const bool is_measured = std::any_of(record.checks.begin(), record.checks.end(), [](const Check& check) {
    return check.measured && check.what != kConditionCheck;
  });
  take(record, is_measured ? Verdict::Pass : Verdict::Inconclusive,
       is_measured ? "" : "none of the pixel checks, which alone judge it, can be measured at this size");
  return opened_where_early(std::move(look), looks, record);
}

// The image without variances that cannot be true.
image::Image with_possible_variances(const image::Image& result, TargetRecord& record) {
  const auto problem = variance_problem(result);
  if (problem.empty()) return result;
  record.remarks.push_back(fmt::format("{}: its variances are not used", problem));
  return without_variances(result);
}

// Whether the two cannot be compared; the record then says why.
bool refuse_pair(const Case& one_case,
                 const image::Image& result,
                 const image::Image& reference,
                 TargetRecord& record) {
  if (const auto problem = stokes_problem(result); metrics::has_stokes(reference) && !problem.empty()) {
    take(record, Verdict::InvalidPixels, problem);
    return true;
  }
  const auto alignment = metrics::check_alignment(result, reference, negatives_of(one_case, record.target));
  if (refuse_negative(one_case, alignment.result, record)) return true;
  if (alignment.alignment == metrics::Alignment::Comparable) return false;
  // The result is usable by promise, so this is about the reference.
  take(record, Verdict::MissingReference, fmt::format("the reference cannot be used: {}", alignment.reason));
  return true;
}

// The two side by side. Where the image contradicts its own variances it loses them.
metrics::ImagePair pair_of(const Case& one_case,
                           image::Image& result,
                           const image::Image& reference,
                           const JudgeSettings& settings,
                           TargetRecord& record) {
  const auto mask = mask_of(one_case, record.target);
  const auto& looks = settings.looks;
  const metrics::PairSettings how{settings.threads, settings.result_noise, looks.most, looks.sample_ratio,
                                  looks.halves,     looks.apart,           looks.spp};
  auto pair = metrics::make_image_pair(result, reference, mask, how);
  if (pair.noise.stated != metrics::StatedNoise::OverstatedByResult) return pair;
  record.remarks.emplace_back(
      "its variances are not used: the image is nearer to the reference than they allow; they must be those of "
      "the mean of a pixel's samples, not of single samples");
  result = without_variances(result);
  return metrics::make_image_pair(result, reference, mask, how);
}

}  // namespace

metrics::Mask mask_of(const Case& one_case, const std::string& target) {
  metrics::Mask mask;
  for (const auto& one : one_case.masks)
    if (one.target == target)
      mask.rectangles.insert(mask.rectangles.end(), one.rectangles.begin(), one.rectangles.end());
  return mask;
}

bool is_difference(const Case& one_case, const std::string& target) {
  return std::any_of(one_case.differences.begin(), one_case.differences.end(),
                     [&](const auto& difference) { return difference.name == target; });
}

Judgement judge_image(const Case& one_case,
                      const image::Image& result,
                      const Reference& reference,
                      const JudgeSettings& settings,
                      TargetRecord& record) {
  const auto& looks = settings.looks;
  if (!registry::no_reference_reason(one_case, record.target).empty())
    return {std::nullopt, judge_by_checks(one_case, result, settings, record)};
  record.reference = reference.file.string();
  if (!reference.image) {
    const auto faults = metrics::count_faults(result, negatives_of(one_case, record.target));
    if (!refuse_negative(one_case, faults, record))
      take(record, Verdict::MissingReference, reference.problem);
    return {};
  }
  record.reference_provenance = provenance_of(*reference.image);
  auto usable = with_possible_variances(result, record);
  if (refuse_pair(one_case, usable, *reference.image, record)) return {};
  const auto pair = pair_of(one_case, usable, *reference.image, settings, record);
  auto comparison = metrics::compare(
      pair, {.no_others = settings.measured == Measured::ForTheVerdict, .also = gate_metrics(one_case)});
  add_measures(comparison, record);
  for (const auto& remark : comparison.bias_remarks) record.remarks.push_back(remark);
  record.hidden = metrics::hidden_by_noise(pair.noise);
  auto checked = check_gates(one_case, pair, comparison, looks.of_first_guess, record);
  for (auto& condition : check_conditions(one_case, usable, settings, record))
    checked.push_back(std::move(condition));
  auto look = look_at(checked, looks);
  take_worst(std::move(checked), record);
  refuse_constant(pair, record);
  refuse_copy(pair, record);
  if (record.verdict == Verdict::Pass && !record.remarks.empty())
    take(record, Verdict::PassWithRemarks, record.remarks.front());
  return {std::move(comparison), opened_where_early(std::move(look), looks, record)};
}

}  // namespace orbs::judge

#include "judge/bad_samples.h"

#include "base/bad_samples.h"
#include "base/text.h"
#include "metrics/seeds.h"

#include <array>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace orbs::judge {

namespace {

constexpr double kMillion = 1e6;

// What one of metrics::kCounters counts.
struct Counted {
  const char* text;    // follows the number
  bool is_of_samples;  // else of rays, of which a sample has several
  bool may_be_right;   // no error for certain
};
constexpr std::array<Counted, metrics::kCounters.size()> kCounted{{
    {"samples were no finite number and are missing", true, false},
    {"searches for a root ended at their limit, where there may be no surface", false, false},
    {"answers of plug-ins broke the rules and counted as misses", false, false},
    {"points of formulas had no gradient, and a normal that is none of theirs", false, false},
    {"hits rest on values that rounding cannot tell from zero: of surfaces that only touch it, or of none",
     false, true},
    {"lookups of an irradiance cache were led below zero by its gradients and set to zero", false, true},
}};

// Nothing where the image has no such attribute.
std::optional<std::string> stated(const image::Image& image, const std::string& attribute) {
  const auto found = image.attributes.find(attribute);
  return found == image.attributes.end() ? std::nullopt : std::optional(found->second);
}

GateResult refusal(const std::string& name,
                   const Counted& counted,
                   double share_ppm,
                   const std::string& found,
                   results::TargetRecord& record) {
  const auto reason = fmt::format("{}, {:.3g} in a million; at most {} in a million may be", found, share_ppm,
                                  kMostBadSamples_ppm);
  record.measures.push_back({name, share_ppm, "ppm",
                             fmt::format("{}, by the image's own count, over its samples", counted.text),
                             true});
  record.checks.push_back(
      {.what = name, .passed = false, .reason = reason, .min = std::nullopt, .max = kMostBadSamples_ppm});
  return {results::Verdict::Fail, reason, share_ppm / kMostBadSamples_ppm};
}

std::optional<GateResult> check_counter(const std::string& attribute,
                                        const Counted& counted,
                                        const image::Image& result,
                                        results::TargetRecord& record) {
  const auto text = stated(result, attribute);
  if (!text) return std::nullopt;
  const auto count = to_integer(*text);
  if (!count || *count < 0) {
    record.remarks.push_back(
        fmt::format("its attribute {} is '{}', expected the number of samples", attribute, *text));
    return std::nullopt;
  }
  if (*count == 0) return std::nullopt;
  const auto spp = to_integer(stated(result, "orbs.spp").value_or(""));
  if (!spp || *spp < 1) {
    record.remarks.push_back(
        fmt::format("{} {}; of how many, it does not say in orbs.spp", *count, counted.text));
    return std::nullopt;
  }
  const double samples = static_cast<double>(*spp) * static_cast<double>(result.pixel_count());
  const double share_ppm = kMillion * static_cast<double>(*count) / samples;
  const auto found = counted.is_of_samples
                         ? fmt::format("{} of {:.3g} {}", *count, samples, counted.text)
                         : fmt::format("in {:.3g} samples {} {}", samples, *count, counted.text);
  if (counted.may_be_right && share_ppm <= kMostBadSamples_ppm) return std::nullopt;
  if (!counted.may_be_right && share_ppm > kMostBadSamples_ppm)
    return refusal(attribute.substr(attribute.find('.') + 1), counted, share_ppm, found, record);
  record.remarks.push_back(fmt::format("{}, {:.2g} in a million", found, share_ppm));
  return std::nullopt;
}

}  // namespace

std::optional<GateResult> check_bad_samples(const image::Image& result, results::TargetRecord& record) {
  std::optional<GateResult> worst;
  for (std::size_t i = 0; i < kCounted.size(); ++i) {
    auto refused = check_counter(metrics::kCounters[i], kCounted[i], result, record);
    if (refused && (!worst || refused->excess > worst->excess)) worst = std::move(refused);
  }
  return worst;
}

}  // namespace orbs::judge

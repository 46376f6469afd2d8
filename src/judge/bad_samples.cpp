#include "judge/bad_samples.h"

#include "base/text.h"

#include <string>

#include <fmt/format.h>

namespace orbs::judge {

namespace {

constexpr double kMillion = 1e6;

// Nothing where the image has no such attribute.
std::optional<std::string> stated(const image::Image& image, const char* attribute) {
  const auto found = image.attributes.find(attribute);
  return found == image.attributes.end() ? std::nullopt : std::optional(found->second);
}

GateResult refusal(double share_ppm, const std::string& are_missing, results::TargetRecord& record) {
  const auto reason = fmt::format("{}, {:.3g} in a million; at most {} in a million may be", are_missing,
                                  share_ppm, kMostBadSamples_ppm);
  record.measures.push_back({"bad_samples", share_ppm, "ppm",
                             "samples of the image that were no finite number and are missing in it, by the "
                             "image's own count",
                             true});
  record.checks.push_back({.what = "bad_samples",
                           .passed = false,
                           .reason = reason,
                           .min = std::nullopt,
                           .max = kMostBadSamples_ppm});
  return {results::Verdict::Fail, reason, share_ppm / kMostBadSamples_ppm};
}

}  // namespace

std::optional<GateResult> check_bad_samples(const image::Image& result, results::TargetRecord& record) {
  const auto text = stated(result, "orbs.bad_samples");
  if (!text) return std::nullopt;
  const auto bad = to_integer(*text);
  if (!bad || *bad < 0) {
    record.remarks.push_back(
        fmt::format("its attribute orbs.bad_samples is '{}', expected the number of samples", *text));
    return std::nullopt;
  }
  if (*bad == 0) return std::nullopt;
  const auto spp = to_integer(stated(result, "orbs.spp").value_or(""));
  if (!spp || *spp < 1) {
    record.remarks.push_back(fmt::format(
        "{} samples were no finite number and are missing; of how many, it does not say in orbs.spp", *bad));
    return std::nullopt;
  }
  const double samples = static_cast<double>(*spp) * static_cast<double>(result.pixel_count());
  const double share_ppm = kMillion * static_cast<double>(*bad) / samples;
  const auto are_missing =
      fmt::format("{} of {:.3g} samples were no finite number and are missing", *bad, samples);
  if (share_ppm > kMostBadSamples_ppm) return refusal(share_ppm, are_missing, record);
  record.remarks.push_back(fmt::format("{}, {:.2g} in a million", are_missing, share_ppm));
  return std::nullopt;
}

}  // namespace orbs::judge

#include "runner/tolerances.h"

#include "metrics/edge_blur.h"
#include "metrics/local_bias.h"
#include "metrics/stokes.h"
#include "runner/gate.h"

#include <array>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::runner {

namespace {

using results::TargetRecord;
using results::Verdict;

void check_means(double tolerance, const metrics::NoiseTest& noise, TargetRecord& record) {
  const std::array<std::pair<const char*, const char*>, 3> channels{
      {{"R", "mean_ratio_r"}, {"G", "mean_ratio_g"}, {"B", "mean_ratio_b"}}};
  for (std::size_t c = 0; c < 3; ++c) {
    const auto& [channel, measure] = channels.at(c);
    const auto result = check_mean_ratio(channel, tolerance, noise.mean_ratio.at(c));
    record.checks.push_back({measure, result.verdict == Verdict::Pass, result.reason, -tolerance, tolerance});
    if (result.verdict != Verdict::Pass) take(record, result.verdict, result.reason);
  }
}

void check_tiles(double tolerance, const std::optional<metrics::LocalBias>& bias, TargetRecord& record) {
  if (!bias) return;
  const auto where = rectangle_numbers(bias->where);
  const bool passed = bias->value <= tolerance;
  const auto reason = fmt::format(
      "the mean of the tile [{}] is off by {:.3g} % or more for sure, at most {:.3g} % is allowed",
      fmt::join(where, ","), 100 * bias->value, 100 * tolerance);
  record.measures.push_back(
      {"local_bias",
       bias->value,
       "1",
       "the largest |mean(result) - mean(reference)| of a tile of 16 x 16 px, less five standard errors "
       "of the tile's own pixels, over the reference's means of tile and image together; of R, G and B "
       "the worst; linear Rec.709, no clamp",
       true,
       false,
       {},
       {},
       where});
  record.checks.push_back({"local_bias", passed, reason, {}, tolerance});
  if (!passed) take(record, Verdict::Fail, reason);
}

void check_edges(double tolerance, const std::optional<metrics::EdgeBlur>& blur, TargetRecord& record) {
  constexpr double kStandardErrors = 3;
  if (!blur) return;
  const double reach = kStandardErrors * blur->standard_error;
  const double low = blur->value - reach;
  const double high = blur->value + reach;
  const bool passed = low <= tolerance && high >= -tolerance;
  const auto reason = fmt::format(
      "its edges are {} than the reference's by {:.3g} ({:.3g} to {:.3g}), at most {:.3g} is allowed",
      blur->value > 0 ? "softer" : "sharper", blur->value, low, high, tolerance);
  record.measures.push_back(
      {"edge_blur",
       blur->value,
       "1",
       "sum of (result - reference) in the direction of change over sum |change|, where change is the "
       "reference filtered by [1 2 1] / 4 in x and y less the reference: 1 is as soft as that filter, "
       "below 0 sharper; over pixels and channels where |change| is above 5 % of filtered reference and "
       "its mean together, each divided by these, and above five standard deviations; linear Rec.709, no "
       "clamp. The interval is three standard errors",
       true,
       true,
       low,
       high,
       {}});
  record.checks.push_back({"edge_blur", passed, reason, -tolerance, tolerance});
  if (!passed) take(record, Verdict::Fail, reason);
}

void check_stokes(double tolerance, const JudgedPair& pair, TargetRecord& record) {
  if (!metrics::has_stokes(pair.reference)) return;
  const auto error = metrics::stokes_error(pair.result, pair.reference, pair.mask);
  if (!error) {
    const std::string reason = "it has no Stokes parameters (layers S1, S2 and S3), which the scene asks for";
    record.checks.push_back({"stokes_error", false, reason, {}, tolerance});
    take(record, Verdict::Fail, reason);
    return;
  }
  const bool passed = *error <= tolerance;
  const auto reason =
      fmt::format("its Stokes parameters are off by {:.3g} % of the light, at most {:.3g} % is allowed",
                  100 * *error, 100 * tolerance);
  record.measures.push_back(
      {"stokes_error",
       *error,
       "1",
       "root mean square over S1, S2, S3 and blocks of 8 x 8 px of mean(result) - mean(reference) in "
       "linear Rec.709 luminance, over the reference's mean luminance",
       true,
       false,
       {},
       {},
       {}});
  record.checks.push_back({"stokes_error", passed, reason, {}, tolerance});
  if (!passed) take(record, Verdict::Fail, reason);
}

}  // namespace

void take(results::TargetRecord& record, results::Verdict verdict, const std::string& reason) {
  if (record.verdict == Verdict::Skipped || results::worse(verdict, record.verdict) != record.verdict) {
    record.verdict = verdict;
    record.reason = reason;
  }
}

std::vector<double> rectangle_numbers(const std::optional<metrics::Rectangle>& where) {
  if (!where) return {};
  return {static_cast<double>(where->x0), static_cast<double>(where->y0), static_cast<double>(where->x1),
          static_cast<double>(where->y1)};
}

void check_tolerances(const registry::Case& one_case, const JudgedPair& pair, TargetRecord& record) {
  const auto& [result, reference, mask, noise] = pair;
  if (one_case.mean_ratio) check_means(*one_case.mean_ratio, noise, record);
  if (one_case.tile_ratio)
    check_tiles(*one_case.tile_ratio, metrics::local_bias(result, reference, mask), record);
  if (one_case.edge_blur)
    check_edges(*one_case.edge_blur, metrics::edge_blur(result, reference, mask), record);
  if (one_case.stokes_error) check_stokes(*one_case.stokes_error, pair, record);
}

}  // namespace orbs::runner

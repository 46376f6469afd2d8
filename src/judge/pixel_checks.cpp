#include "judge/pixel_checks.h"

#include "judge/noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::judge {

using results::Check;
using results::Verdict;

namespace {

std::array<double, 3> mean_of_region(const image::Image& image, const Rectangle& region) {
  std::array<double, 3> sum{};
  const std::array<int, 3> channels{image::channel_index(image, "R"), image::channel_index(image, "G"),
                                    image::channel_index(image, "B")};
  for (int y = region.y0; y < region.y1; ++y)
    for (int x = region.x0; x < region.x1; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        sum.at(c) += static_cast<double>(image.at(x, y, static_cast<std::size_t>(channels.at(c))));
  const double count = static_cast<double>(region.x1 - region.x0) * (region.y1 - region.y0);
  for (auto& value : sum) value /= count;
  return sum;
}

bool states_noise(const image::Image& image) {
  return image::channel_index(image, "variance.R") >= 0 && variance_problem(image).empty();
}

// Of the region's mean, as the noise of pixels is independent; 0 where the image does not state its noise.
std::array<double, 3> standard_errors_of_region(const image::Image& image, const Rectangle& region) {
  std::array<double, 3> errors{};
  if (!states_noise(image)) return errors;
  const auto variance = image::select_rgb(image, "variance.");
  for (int y = region.y0; y < region.y1; ++y)
    for (int x = region.x0; x < region.x1; ++x)
      for (std::size_t c = 0; c < 3; ++c) errors.at(c) += static_cast<double>(variance.at(x, y, c));
  const double count = static_cast<double>(region.x1 - region.x0) * (region.y1 - region.y0);
  for (auto& error : errors) error = std::sqrt(error) / count;
  return errors;
}

// Samples that all were black have no scatter, and a standard error of 0 claims what they cannot know: light
// that one sample in a thousand finds is missing from most regions of a hundred samples. A region that should
// be black needs no such doubt.
bool is_black_by_chance(const registry::PixelCheck& check, const image::Image& image) {
  const std::array<double, 3> black{};
  return check.standard_errors > 0 && states_noise(image) && check.expected != black &&
         mean_of_region(image, check.region) == black &&
         standard_errors_of_region(image, check.region) == black;
}

}  // namespace

Check check_pixels(const registry::PixelCheck& check, const image::Image& image) {
  if (!check.not_measured.empty()) {
    const auto what = fmt::format("pixels {}", rectangle_text(check.region));
    return {what, false, fmt::format("{}: {}", what, check.not_measured), {}, {}, false};
  }
  const auto mean = mean_of_region(image, check.region);
  const auto errors = standard_errors_of_region(image, check.region);
  Check out{fmt::format("pixels {}", rectangle_text(check.region)), true, "", {}, {}};
  for (std::size_t c = 0; c < 3; ++c)
    out.passed =
        out.passed && std::fabs(mean.at(c) - check.expected.at(c)) + check.standard_errors * errors.at(c) <=
                          check.tolerance;
  const auto noise = check.standard_errors > 0 ? fmt::format(" with {} standard errors of ({:.2g})",
                                                             check.standard_errors, fmt::join(errors, ", "))
                                               : "";
  out.reason =
      fmt::format("{} have the linear mean ({:.6g}){}, expected ({:.6g}) within {} ({})", out.what,
                  fmt::join(mean, ", "), noise, fmt::join(check.expected, ", "), check.tolerance, check.why);
  if (is_black_by_chance(check, image))
    out.reason += "; all its samples are black: the light is missing, or so rare that it needs more samples";
  return out;
}

Verdict verdict_of_missed_check(const registry::PixelCheck& check, const image::Image& image) {
  const auto mean = mean_of_region(image, check.region);
  const auto errors = standard_errors_of_region(image, check.region);
  if (is_black_by_chance(check, image)) return Verdict::Inconclusive;
  for (std::size_t c = 0; c < 3; ++c)
    if (std::fabs(mean.at(c) - check.expected.at(c)) - check.standard_errors * errors.at(c) > check.tolerance)
      return Verdict::Fail;
  return Verdict::Inconclusive;
}

double excess_of_missed_check(const registry::PixelCheck& check, const image::Image& image) {
  const auto mean = mean_of_region(image, check.region);
  double farthest = 0;
  for (std::size_t c = 0; c < 3; ++c)
    farthest = std::max(farthest, std::fabs(mean.at(c) - check.expected.at(c)));
  return check.tolerance > 0 ? farthest / check.tolerance : std::numeric_limits<double>::infinity();
}

}  // namespace orbs::judge

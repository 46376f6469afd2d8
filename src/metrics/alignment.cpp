#include "metrics/alignment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::metrics {

namespace {

using image::Image;

constexpr std::array kColours{"R", "G", "B"};
constexpr float kLargestFinite = std::numeric_limits<float>::max();

std::string missing_channels(const Image& image) {
  std::vector<std::string> missing;
  for (const char* name : kColours)
    if (image::channel_index(image, name) < 0) missing.emplace_back(name);
  return fmt::format("{}", fmt::join(missing, ", "));
}

std::array<std::size_t, 3> colour_indices(const Image& image) {
  std::array<std::size_t, 3> indices{};
  for (std::size_t c = 0; c < 3; ++c)
    indices[c] = static_cast<std::size_t>(image::channel_index(image, kColours[c]));
  return indices;
}

void count_pixel(const std::array<float, 3>& rgb, PixelFaults& faults) {
  std::array<bool, 3> seen{};
  for (const float value : rgb) {
    seen[0] = seen[0] || std::isnan(value);
    seen[1] = seen[1] || std::isinf(value);
    seen[2] = seen[2] || value < 0.0F;
  }
  faults.nan += seen[0] ? 1 : 0;
  faults.infinite += seen[1] ? 1 : 0;
  faults.negative += seen[2] ? 1 : 0;
}

// Where the pixel is and its first value that is a fault; empty when it has none.
std::string describe_pixel(const std::array<float, 3>& rgb,
                           std::size_t pixel,
                           int width,
                           NegativePixels negatives) {
  const auto row_length = static_cast<std::size_t>(width);
  for (std::size_t c = 0; c < 3; ++c) {
    const bool fits = std::isfinite(rgb[c]) && (rgb[c] >= 0.0F || negatives == NegativePixels::Allowed);
    if (!fits)
      return fmt::format("({}, {}), channel {}, value {}", pixel % row_length, pixel / row_length,
                         kColours[c], rgb[c]);
  }
  return {};
}

void stretch(std::array<int, 4>& box, std::size_t pixel, int width) {
  const int x = static_cast<int>(pixel % static_cast<std::size_t>(width));
  const int y = static_cast<int>(pixel / static_cast<std::size_t>(width));
  if (box[2] == 0) box = {x, y, x + 1, y + 1};
  box = {std::min(box[0], x), box[1], std::max(box[2], x + 1), y + 1};
}

std::string describe_faults(const char* whose, const PixelFaults& faults) {
  return fmt::format(
      "the {} has pixels with bad numbers: {} with NaN, {} infinite, {} negative; the first at {}", whose,
      faults.nan, faults.infinite, faults.negative, faults.first);
}

}  // namespace

PixelFaults count_faults(const Image& image, NegativePixels negatives) {
  const auto index = colour_indices(image);
  PixelFaults faults;
  for (std::size_t pixel = 0; pixel < image.pixel_count(); ++pixel) {
    const float* values = &image.pixels[pixel * image.channel_count()];
    const std::array rgb{values[index[0]], values[index[1]], values[index[2]]};
    bool good = true;  // NaN fails both comparisons
    for (const float value : rgb) good = good && value >= 0.0F && value <= kLargestFinite;
    if (good) continue;
    count_pixel(rgb, faults);
    const auto described = describe_pixel(rgb, pixel, image.width, negatives);
    if (described.empty()) continue;
    if (faults.first.empty()) faults.first = described;
    stretch(faults.box, pixel, image.width);
  }
  return faults;
}

AlignmentReport check_alignment(const Image& result, const Image& reference, NegativePixels negatives) {
  AlignmentReport report;
  if (result.width != reference.width || result.height != reference.height || result.pixel_count() == 0) {
    report.alignment = Alignment::WrongSize;
    report.reason = fmt::format("the result is {} x {} px, the reference {} x {} px", result.width,
                                result.height, reference.width, reference.height);
    return report;
  }
  for (const auto& [whose, image] : {std::pair{"result", &result}, std::pair{"reference", &reference}}) {
    const std::string missing = missing_channels(*image);
    if (missing.empty()) continue;
    report.alignment = Alignment::WrongChannels;
    report.reason =
        fmt::format("the {} has no channel {}; it has {}", whose, missing, fmt::join(image->channels, ", "));
    return report;
  }
  report.result = count_faults(result, negatives);
  report.reference = count_faults(reference, negatives);
  report.reason = "both images have the same size, the channels R, G, B and valid numbers";
  if (report.result.first.empty() && report.reference.first.empty()) return report;
  report.alignment = Alignment::InvalidPixels;
  report.reason = report.result.first.empty() ? describe_faults("reference", report.reference)
                                              : describe_faults("result", report.result);
  return report;
}

}  // namespace orbs::metrics

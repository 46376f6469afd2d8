#include "run/wrong_regions.h"

#include "scene/seen_at.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include <fmt/format.h>

namespace orbs::run {

namespace {

using results::Measure;
using results::TargetRecord;
using results::WrongRegion;

// Means of R, G and B over the same pixels.
struct Means {
  std::array<double, 3> result{};
  std::array<double, 3> reference{};
};

Means means_over(const std::vector<double>& where,
                 const std::array<image::Image, 2>& rgb,
                 const std::vector<std::uint8_t>& included) {
  const auto& [result, reference] = rgb;
  Means means;
  double count = 0;
  for (auto y = static_cast<std::size_t>(where[1]); y < static_cast<std::size_t>(where[3]); ++y)
    for (auto x = static_cast<std::size_t>(where[0]); x < static_cast<std::size_t>(where[2]); ++x) {
      const auto pixel = y * static_cast<std::size_t>(reference.width) + x;
      if (included[pixel] == 0) continue;
      ++count;
      for (std::size_t c = 0; c < 3; ++c) {
        means.result.at(c) += static_cast<double>(result.pixels[3 * pixel + c]);
        means.reference.at(c) += static_cast<double>(reference.pixels[3 * pixel + c]);
      }
    }
  for (std::size_t c = 0; c < 3; ++c) {
    means.result.at(c) /= count;
    means.reference.at(c) /= count;
  }
  return means;
}

double share_of(double result, double reference) { return result / reference - 1; }

std::string percent(double share) {
  const double value = 100 * std::fabs(share);
  return value < 99.5 ? fmt::format("{:.2g} %", value) : fmt::format("{:.0f} %", value);
}

// "4 % too dark". Where the brightness says less than half of what a channel does, it is the colour. A
// channel counts in shares of the reference's mean there, at least of a tenth of the image's, as in
// window_error_16px.
std::string how_far_off(const Means& means, const std::array<double, 3>& of_image) {
  const auto& [result, reference] = means;
  const double level =
      share_of(result[0] + result[1] + result[2], reference[0] + reference[1] + reference[2]);
  if (!std::isfinite(level)) return "bright where it is black";
  std::array<double, 3> shares{};
  double worst = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const double of = std::max(reference.at(c), of_image.at(c) / 10);
    if (of > 0) shares.at(c) = (result.at(c) - reference.at(c)) / of;
    worst = std::max(worst, std::fabs(shares.at(c)));
  }
  if (2 * std::fabs(level) >= worst)
    return fmt::format("{} too {}", percent(level), level < 0 ? "dark" : "bright");
  std::string text = "of another colour:";
  for (std::size_t c = 0; c < 3; ++c)
    text += fmt::format(" {} {}{}", "RGB"[c], shares.at(c) < 0 ? "-" : "+", percent(shares.at(c)));
  return text;
}

// "upper left", by thirds of the image.
std::string place_of(const std::vector<double>& where, const image::Image& image) {
  const auto third = [](double middle, int size) {
    return std::clamp(static_cast<int>(3 * middle / size), 0, 2);
  };
  constexpr std::array kColumns{"left", "middle", "right"};
  constexpr std::array kRows{"upper", "middle", "lower"};
  const int column = third((where[0] + where[2]) / 2, image.width);
  const int row = third((where[1] + where[3]) / 2, image.height);
  if (row == 1) return kColumns.at(static_cast<std::size_t>(column));
  if (column == 1) return fmt::format("{} middle", kRows.at(static_cast<std::size_t>(row)));
  return fmt::format("{} {}", kRows.at(static_cast<std::size_t>(row)),
                     kColumns.at(static_cast<std::size_t>(column)));
}

// The middles of 5 x 5 cells of the rectangle.
std::vector<scene::ImagePoint> points_in(const std::vector<double>& where) {
  constexpr int kPerSide = 5;
  std::vector<scene::ImagePoint> points;
  for (int j = 0; j < kPerSide; ++j)
    for (int i = 0; i < kPerSide; ++i)
      points.push_back({where[0] + (where[2] - where[0]) * (i + 0.5) / kPerSide,
                        where[1] + (where[3] - where[1]) * (j + 0.5) / kPerSide});
  return points;
}

// Whether a check of this measure, which tells an error of a mean from noise, was missed for certain.
bool is_wrong_for_certain(const TargetRecord& record, const Measure& measure) {
  const bool is_of_mean = measure.name.starts_with("window_error_") || measure.name == "local_bias";
  return is_of_mean && measure.where.size() == 4 &&
         std::any_of(record.checks.begin(), record.checks.end(), [&](const auto& check) {
           return check.what == measure.name && check.measured && check.decided && !check.passed;
         });
}

double area(const std::vector<double>& where) { return (where[2] - where[0]) * (where[3] - where[1]); }

}  // namespace

std::vector<WrongRegion> wrong_regions(const TargetRecord& record,
                                       const image::Image& result,
                                       const image::Image& reference,
                                       const metrics::Mask& mask,
                                       const scene::Scene* scene) {
  std::vector<WrongRegion> regions;
  std::vector<std::vector<scene::ImagePoint>> points;
  for (const auto& measure : record.measures) {
    if (!is_wrong_for_certain(record, measure)) continue;
    regions.push_back({.where = measure.where});
    points.push_back(points_in(measure.where));
  }
  if (regions.empty()) return regions;  // of nearly all images
  const auto seen =
      scene == nullptr ? std::vector<std::string>(regions.size()) : scene::seen_by_most(*scene, points);
  const std::array rgb{image::select_rgb(result, ""), image::select_rgb(reference, "")};
  const auto included = metrics::included_pixels(mask, reference.width, reference.height);
  const std::vector<double> all{0, 0, static_cast<double>(reference.width),
                                static_cast<double>(reference.height)};
  const auto of_image = means_over(all, rgb, included).reference;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    auto& region = regions[i];
    region.seen = seen[i];
    region.text = fmt::format("the {}, {}", seen[i].empty() ? place_of(region.where, reference) : seen[i],
                              how_far_off(means_over(region.where, rgb, included), of_image));
  }
  std::stable_sort(regions.begin(), regions.end(),
                   [](const auto& a, const auto& b) { return area(a.where) > area(b.where); });
  return regions;
}

}  // namespace orbs::run

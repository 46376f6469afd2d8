#include "run/wrong_regions.h"

#include "scene/seen_at.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include <fmt/format.h>

namespace orbs::run {

namespace {

using results::Measure;
using results::TargetRecord;
using results::WrongRegion;

struct Means {
  std::array<double, 3> result{};  // sums over the same pixels of R, G and B, as good as means for shares
  std::array<double, 3> reference{};
};

Means means_over(const std::vector<double>& where,
                 const image::Image& result,
                 const image::Image& reference,
                 const metrics::Mask& mask) {
  const auto included = metrics::included_pixels(mask, reference.width, reference.height);
  const auto [of_result, of_reference] =
      std::array{image::select_rgb(result, ""), image::select_rgb(reference, "")};
  Means means;
  for (auto y = static_cast<std::size_t>(where[1]); y < static_cast<std::size_t>(where[3]); ++y)
    for (auto x = static_cast<std::size_t>(where[0]); x < static_cast<std::size_t>(where[2]); ++x) {
      const auto pixel = y * static_cast<std::size_t>(reference.width) + x;
      if (included[pixel] == 0) continue;
      for (std::size_t c = 0; c < 3; ++c) {
        means.result.at(c) += static_cast<double>(of_result.pixels[3 * pixel + c]);
        means.reference.at(c) += static_cast<double>(of_reference.pixels[3 * pixel + c]);
      }
    }
  return means;
}

double share_of(double result, double reference) { return result / reference - 1; }

std::string percent(double share) {
  const double value = 100 * std::fabs(share);
  return value < 99.5 ? fmt::format("{:.2g} %", value) : fmt::format("{:.0f} %", value);
}

// "4 % too dark". Where the brightness says less than half of what a channel does, it is the colour.
std::string how_far_off(const Means& means) {
  const auto& [result, reference] = means;
  const double level =
      share_of(result[0] + result[1] + result[2], reference[0] + reference[1] + reference[2]);
  if (!std::isfinite(level)) return "bright where it is black";
  std::array<double, 3> shares{};
  double worst = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    shares.at(c) = share_of(result.at(c), reference.at(c));
    if (std::isfinite(shares.at(c))) worst = std::max(worst, std::fabs(shares.at(c)));
  }
  if (2 * std::fabs(level) >= worst)
    return fmt::format("{} too {}", percent(level), level < 0 ? "dark" : "bright");
  std::string text = "of another colour:";
  for (std::size_t c = 0; c < 3; ++c)
    if (std::isfinite(shares.at(c)))
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
  for (const auto& measure : record.measures) {
    if (!is_wrong_for_certain(record, measure)) continue;
    WrongRegion region{.where = measure.where};
    if (scene != nullptr) region.seen = scene::seen_by_most(*scene, points_in(measure.where));
    region.text =
        fmt::format("the {}, {}", region.seen.empty() ? place_of(measure.where, reference) : region.seen,
                    how_far_off(means_over(measure.where, result, reference, mask)));
    regions.push_back(std::move(region));
  }
  std::stable_sort(regions.begin(), regions.end(),
                   [](const auto& a, const auto& b) { return area(a.where) > area(b.where); });
  return regions;
}

}  // namespace orbs::run

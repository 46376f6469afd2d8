#include "studies/effects/paired_difference.h"

#include "base/statistics.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace orbs::studies {

namespace {

// What one pixel adds to the sums of its block and of the image.
struct DifferenceSums {
  double level = 0;             // of the original images
  double difference = 0;        // mean over the pairs
  double pixels = 0;            // mean of its absolute values
  double variance = 0;          // of that mean
  double squared_variance = 0;  // for the degrees of freedom
  double count = 0;

  DifferenceSums& operator+=(const DifferenceSums& other) {
    level += other.level;
    difference += other.difference;
    pixels += other.pixels;
    variance += other.variance;
    squared_variance += other.squared_variance;
    count += other.count;
    return *this;
  }
};

double grey_at(const image::Image& image, int x, int y) {
  return (static_cast<double>(image.at(x, y, 0)) + static_cast<double>(image.at(x, y, 1)) +
          static_cast<double>(image.at(x, y, 2))) /
         3;
}

DifferenceSums sums_of_pixel(const std::vector<image::Image>& original,
                             const std::vector<image::Image>& changed,
                             int x,
                             int y) {
  const auto pairs = static_cast<double>(original.size());
  DifferenceSums sums;
  sums.count = 1;
  for (std::size_t i = 0; i < original.size(); ++i) {
    sums.level += grey_at(original[i], x, y) / pairs;
    const double difference = grey_at(changed[i], x, y) - grey_at(original[i], x, y);
    sums.difference += difference / pairs;
    sums.pixels += std::fabs(difference) / pairs;
  }
  if (original.size() == 1) return sums;
  for (std::size_t i = 0; i < original.size(); ++i) {
    const double deviation = grey_at(changed[i], x, y) - grey_at(original[i], x, y) - sums.difference;
    sums.variance += deviation * deviation / (pairs - 1) / pairs;
  }
  sums.squared_variance = sums.variance * sums.variance;
  return sums;
}

RelativeDifference relative(const DifferenceSums& sums, double least_level, std::size_t pairs, double looks) {
  const double level = std::fmax(sums.level / sums.count, least_level);
  // Where the original is black, there is nothing to be relative to: the difference itself is given.
  const double unit = level > 0 ? level : 1;
  RelativeDifference out;
  out.value = sums.difference / sums.count / unit;
  out.standard_error = std::sqrt(sums.variance) / sums.count / unit;
  if (out.value == 0) return out;
  double outside = 0;
  if (out.standard_error > 0) {
    const double degrees =
        static_cast<double>(pairs - 1) * sums.variance * sums.variance / sums.squared_variance;
    outside = student_tail(out.value / out.standard_error, degrees);
  }
  out.confidence = std::fmax(0.0, 1 - outside * looks);
  return out;
}

// Whether `a` is the block to be named rather than `b`.
bool is_clearer(const RelativeDifference& a, const RelativeDifference& b) {
  const bool a_is_sure = a.confidence >= kSure;
  if (a_is_sure != (b.confidence >= kSure)) return a_is_sure;
  return a_is_sure ? std::fabs(a.value) > std::fabs(b.value) : a.confidence > b.confidence;
}

template <typename Visit>
void for_each_block(const image::Image& image, Visit visit) {
  for (int y = 0; y < image.height; y += kStabilityBlock_px)
    for (int x = 0; x < image.width; x += kStabilityBlock_px) visit(x, y);
}

}  // namespace

image::Image original_of(const image::Image& changed, const scene::RelatedImage& related) {
  const auto colours = image::select_rgb(changed, "");
  image::Image out = colours;
  const bool is_mirrored = std::holds_alternative<scene::MirroredImage>(related);
  const bool is_rotated = std::holds_alternative<scene::RotatedChannels>(related);
  const auto* multiplied = std::get_if<scene::MultipliedImage>(&related);
  const double divisor = multiplied != nullptr ? multiplied->factor : 1;
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        const float value = colours.at(is_mirrored ? out.width - 1 - x : x, y, is_rotated ? (c + 2) % 3 : c);
        out.at(x, y, c) = static_cast<float>(static_cast<double>(value) / divisor);
      }
  return out;
}

PairedDifference paired_difference(const std::vector<image::Image>& original,
                                   const std::vector<image::Image>& changed) {
  PairedDifference out;
  out.is_equal = std::equal(original.begin(), original.end(), changed.begin(), image::has_same_colours);
  if (out.is_equal) return out;
  const auto& first = original.front();
  DifferenceSums whole;
  std::vector<DifferenceSums> blocks;
  for_each_block(first, [&](int x0, int y0) {
    DifferenceSums block;
    for (int y = y0; y < std::min(y0 + kStabilityBlock_px, first.height); ++y)
      for (int x = x0; x < std::min(x0 + kStabilityBlock_px, first.width); ++x)
        block += sums_of_pixel(original, changed, x, y);
    whole += block;
    blocks.push_back(block);
  });
  const double looks = static_cast<double>(blocks.size()) + 1;
  out.mean = relative(whole, 0, original.size(), looks);
  out.pixels = whole.pixels / (whole.level > 0 ? whole.level : whole.count);
  constexpr double kDarkest = 0.1;
  std::size_t index = 0;
  for_each_block(first, [&](int x, int y) {
    const auto block =
        relative(blocks[index++], kDarkest * whole.level / whole.count, original.size(), looks);
    if (!is_clearer(block, out.largest)) return;
    out.largest = block;
    out.x = x;
    out.y = y;
  });
  return out;
}

image::Image mean_difference(const std::vector<image::Image>& original,
                             const std::vector<image::Image>& changed) {
  auto out = image::make_image(original.front().width, original.front().height, {"R", "G", "B"});
  const auto pairs = static_cast<double>(original.size());
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        double sum = 0;
        for (std::size_t i = 0; i < original.size(); ++i)
          sum += static_cast<double>(changed[i].at(x, y, c)) - static_cast<double>(original[i].at(x, y, c));
        out.at(x, y, c) = static_cast<float>(sum / pairs);
      }
  return out;
}

}  // namespace orbs::studies

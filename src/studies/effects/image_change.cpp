#include "studies/effects/image_change.h"

#include "image/colour.h"
#include "metrics/describe.h"
#include "metrics/seeds.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace orbs::studies {

namespace {

MeanOfRounds mean_of_rounds(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  double sum = 0;
  for (const double v : values) sum += v;
  double scatter = 0;
  for (const double v : values) scatter += (v - sum / n) * (v - sum / n);
  return {sum / n, std::sqrt(scatter / (n - 1) / n)};
}

double luminance_at(const image::Image& image, int x, int y) {
  return image::luminance(static_cast<double>(image.at(x, y, 0)), static_cast<double>(image.at(x, y, 1)),
                          static_cast<double>(image.at(x, y, 2)));
}

// Mean luminance of the pixels [x0, x0 + width) x [y0, y0 + height) that there are.
double block_mean(const image::Image& image, int x0, int y0, int width, int height) {
  double sum = 0;
  int count = 0;
  for (int y = y0; y < std::min(y0 + height, image.height); ++y)
    for (int x = x0; x < std::min(x0 + width, image.width); ++x, ++count) sum += luminance_at(image, x, y);
  return sum / count;
}

// What the image was made with besides camera paths: light paths cost time of their own and find light that
// camera paths miss.
std::array<bool, 2> light_paths_of(const image::Image& image) {
  const auto has = [&](const char* name) {
    const auto found = image.attributes.find(name);
    return found != image.attributes.end() && found->second == "yes";
  };
  return {has("orbs.light_paths"), has("orbs.light_connections")};
}

}  // namespace

ImageChange change_between(const std::vector<image::Image>& usual, const std::vector<image::Image>& other) {
  const int width = usual.front().width;
  const int height = usual.front().height;
  const auto changes = [&](int x, int y, int w, int h) {
    std::vector<double> values;
    for (std::size_t i = 0; i < usual.size(); ++i)
      values.push_back(block_mean(other[i], x, y, w, h) - block_mean(usual[i], x, y, w, h));
    return mean_of_rounds(values);
  };
  double whole = 0;
  for (const auto& image : usual)
    whole += block_mean(image, 0, 0, width, height) / static_cast<double>(usual.size());
  const auto relative = [&](MeanOfRounds m) {
    return whole > 0 ? MeanOfRounds{m.value / whole, m.standard_error / whole} : m;
  };
  ImageChange change;
  change.is_comparable = light_paths_of(usual.front()) == light_paths_of(other.front());
  change.is_equal = std::equal(usual.begin(), usual.end(), other.begin(), image::has_same_colours);
  if (change.is_equal) return change;
  change.mean = relative(changes(0, 0, width, height));
  for (int y = 0; y < height; y += metrics::kBlock_px)
    for (int x = 0; x < width; x += metrics::kBlock_px) {
      const auto found = relative(changes(x, y, metrics::kBlock_px, metrics::kBlock_px));
      if (std::abs(found.value) <= std::abs(change.largest.value)) continue;
      change.largest = found;
      change.x = x;
      change.y = y;
    }
  // As where no light is found at all.
  if (metrics::are_equal(usual) || metrics::are_equal(other)) {
    change.bias = "the images differ, and one of the two has no noise";
    return change;
  }
  change.bias = metrics::bias_message(
      metrics::test_noise(metrics::mean_and_variance_of(other), metrics::mean_and_variance_of(usual)));
  return change;
}

double mean_variance(const std::vector<image::Image>& images) {
  double sum = 0;
  for (const auto& image : images)
    for (const float variance : image::select_rgb(image, "variance.").pixels)
      sum += static_cast<double>(variance);
  return sum / (3 * static_cast<double>(images.size() * images.front().pixel_count()));
}

}  // namespace orbs::studies

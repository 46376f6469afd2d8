#include "tracer/render/film.h"

#include "tracer/integrator/path_class.h"

#include <algorithm>
#include <limits>
#include <tuple>

#include <fmt/format.h>

namespace orbs::tracer {

void add_sample(PixelSums& pixel, Vec3d radiance) {
  pixel.current += radiance;
  pixel.current_count += 1;
}

void end_replicate(PixelSums& pixel) {
  if (pixel.current_count == 0) return;
  pixel.finished += pixel.current;
  pixel.weighted_squares += pixel.current * pixel.current / pixel.current_count;
  pixel.finished_count += pixel.current_count;
  pixel.replicates += 1;
  pixel.current = {};
  pixel.current_count = 0;
}

Vec3d mean_of(const PixelSums& pixel) {
  const double count = pixel.finished_count + pixel.current_count;
  return count > 0 ? (pixel.finished + pixel.current) / count : Vec3d{};
}

Vec3d variance_of_mean(const PixelSums& pixel) {
  if (pixel.replicates < 2) return {};
  const Vec3d mean = pixel.finished / pixel.finished_count;
  const Vec3d scatter = pixel.weighted_squares - mean * mean * pixel.finished_count;
  const double factor = 1 / ((pixel.replicates - 1) * pixel.finished_count);
  // Rounding only: the exact scatter is not negative.
  return {std::max(0.0, scatter.x) * factor, std::max(0.0, scatter.y) * factor,
          std::max(0.0, scatter.z) * factor};
}

void merge(BadSamples& all, const BadSamples& more) {
  if (more.count == 0) return;
  const bool is_earlier = std::tie(more.first_y, more.first_x) < std::tie(all.first_y, all.first_x);
  if (all.count == 0 || is_earlier) {
    all.first_x = more.first_x;
    all.first_y = more.first_y;
  }
  all.count += more.count;
}

Film make_film(int width, int height) {
  Film film{width, height, {}, {}, {}, true};
  film.pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  return film;
}

bool float_holds_variances(const Film& film) {
  double largest = 0;
  double brightest = 0;
  for (const PixelSums& pixel : film.pixels) {
    const Vec3d variance = variance_of_mean(pixel);
    const Vec3d mean = mean_of(pixel);
    largest = std::max({largest, variance.x, variance.y, variance.z});
    brightest = std::max({brightest, mean.x, mean.y, mean.z});
  }
  const double colour_rounding = brightest * 0x1p-24;
  constexpr double kMost = std::numeric_limits<float>::max();
  constexpr double kLeast = std::numeric_limits<float>::min() * 0x1p24;  // smaller ones still count beside it
  return largest <= colour_rounding * colour_rounding || (largest >= kLeast && largest <= kMost);
}

namespace {

void store(image::Image& image, std::size_t pixel, std::size_t channel, Vec3d value) {
  float* at = &image.pixels[pixel * image.channel_count() + channel];
  at[0] = static_cast<float>(value.x);
  at[1] = static_cast<float>(value.y);
  at[2] = static_cast<float>(value.z);
}

}  // namespace

image::Image resolve(const Film& film) {
  std::vector<std::string> channels;
  // Sums to be divided by the number of samples, in the order of the channels after R, G, B and their
  // variance.
  std::vector<const std::vector<Vec3d>*> layers;
  const auto add_layer = [&](const std::string& prefix) {
    for (const char* colour : {"R", "G", "B"}) channels.push_back(prefix + colour);
  };
  add_layer("");
  if (film.has_variance) add_layer("variance.");
  const std::size_t first_layer = channels.size();
  for (std::size_t c = 0; c < film.class_sums.size(); ++c) {
    if (film.class_sums[c].empty()) continue;
    layers.push_back(&film.class_sums[c]);
    add_layer("path." + path_class_name(static_cast<int>(c)) + ".");
  }
  for (std::size_t k = 0; k < film.stokes.size(); ++k) {
    layers.push_back(&film.stokes[k]);
    add_layer(fmt::format("S{}.", k + 1));
  }
  if (!film.stokes.empty()) add_layer("S0.");
  auto image = image::make_image(film.width, film.height, channels);
  for (std::size_t i = 0; i < film.pixels.size(); ++i) {
    const PixelSums& pixel = film.pixels[i];
    const double count = pixel.finished_count + pixel.current_count;
    store(image, i, 0, mean_of(pixel));
    if (film.has_variance) store(image, i, 3, variance_of_mean(pixel));
    for (std::size_t k = 0; k < layers.size(); ++k)
      store(image, i, first_layer + 3 * k, count > 0 ? (*layers[k])[i] / count : Vec3d{});
    if (!film.stokes.empty()) store(image, i, first_layer + 3 * layers.size(), mean_of(pixel));
  }
  return image;
}

}  // namespace orbs::tracer

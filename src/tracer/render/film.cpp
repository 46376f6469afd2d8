#include "tracer/render/film.h"

#include "base/nth.h"
#include "tracer/integrator/path_class.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include <fmt/format.h>

namespace orbs::tracer {

void add_sample(PixelSums& pixel, Vec3d radiance) {
  pixel.current += radiance;
  pixel.current_count += 1;
}

Vec3d mean_of(const PixelSums& pixel) {
  return pixel.finished_count > 0 ? pixel.finished / pixel.finished_count : Vec3d{};
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
  Film film;
  film.width = width;
  film.height = height;
  film.pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  return film;
}

Vec3d mean_of(const Film& film, std::size_t pixel) {
  const Vec3d mean = mean_of(film.pixels[pixel]);
  if (film.finished_splats.empty() || film.pixels[pixel].finished_count == 0) return mean;
  return mean + film.finished_splats[pixel] / film.pixels[pixel].finished_count;
}

void end_piece(Film& film, std::size_t pixel, int piece) {
  PixelSums& sums = film.pixels[pixel];
  Vec3d splats{};
  if (!film.splats.empty()) splats = std::exchange(film.splats[pixel], Vec3d{});
  if (piece < static_cast<int>(film.pieces.size()) && sums.current_count > 0) {
    nth(film.pieces, piece)[pixel] = cast<float>(sums.current / sums.current_count);
    if (!film.splats.empty()) nth(film.splat_pieces, piece)[pixel] = cast<float>(splats / sums.current_count);
  }
  sums.finished += sums.current;
  if (!film.splats.empty()) film.finished_splats[pixel] += splats;
  sums.finished_count += sums.current_count;
  sums.current = {};
  sums.current_count = 0;
}

namespace {

void store(image::Image& image, std::size_t pixel, std::size_t channel, Vec3d value) {
  float* at = &image.pixels[pixel * image.channel_count() + channel];
  at[0] = static_cast<float>(value.x);
  at[1] = static_cast<float>(value.y);
  at[2] = static_cast<float>(value.z);
}

// Noise that is too small for floats beside that of brighter pixels is stated as the least float: 0 would say
// that there is none.
Vec3d not_below_floats(Vec3d variance) {
  const auto stated = [](double v) {
    constexpr double kLeast = std::numeric_limits<float>::denorm_min();
    return v > kLeast || v == 0 ? v : kLeast;
  };
  return {stated(variance.x), stated(variance.y), stated(variance.z)};
}

}  // namespace

image::Image resolve(const Film& film, const std::vector<Vec3d>& variances) {
  std::vector<std::string> channels;
  // Sums to be divided by the number of samples, in the order of the channels after R, G, B and their
  // variance.
  std::vector<const std::vector<Vec3d>*> layers;
  const auto add_layer = [&](const std::string& prefix) {
    for (const char* colour : {"R", "G", "B"}) channels.push_back(prefix + colour);
  };
  add_layer("");
  if (!variances.empty()) add_layer("variance.");
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
    const double count = film.pixels[i].finished_count;
    const Vec3d mean = mean_of(film, i);
    store(image, i, 0, mean);
    if (!variances.empty()) store(image, i, 3, not_below_floats(variances[i]));
    for (std::size_t k = 0; k < layers.size(); ++k)
      store(image, i, first_layer + 3 * k, count > 0 ? (*layers[k])[i] / count : Vec3d{});
    if (!film.stokes.empty()) store(image, i, first_layer + 3 * layers.size(), mean);
  }
  return image;
}

}  // namespace orbs::tracer

#include "adapters/environment_image.h"

#include "base/error.h"
#include "base/nth.h"
#include "image/image_io.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace orbs::adapters {

namespace {

image::Image tinted_map(const scene::Scene& scene) {
  const auto& texture = nth(scene.textures, scene.environment.map.value().texture);
  const scene::RgbColour tint = scene.environment.radiance;
  const std::array factors{tint.x, tint.y, tint.z};
  auto image = with_note(fmt::format("reading environment map '{}'", texture.name), [&] {
    return image::read_linear_rgb(texture.file, texture.encoding == scene::Encoding::Linear
                                                    ? image::Encoded::Numbers
                                                    : image::Encoded::Srgb);
  });
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = static_cast<float>(static_cast<double>(image.pixels[i]) * factors[i % 3]);
  return image;
}

void mirror_columns(image::Image& image) {
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width / 2; ++x)
      for (std::size_t c = 0; c < 3; ++c) std::swap(image.at(x, y, c), image.at(image.width - 1 - x, y, c));
}

// Bilinear, u wraps and v ends at the outermost rows.
std::array<float, 3> looked_up(const image::Image& image, Vec2d uv) {
  const double at_x = uv.x * image.width - 0.5;
  const double at_y = std::clamp((1 - uv.y) * image.height - 0.5, 0.0, image.height - 1.0);
  const int left = static_cast<int>(std::floor(at_x));
  const int top = static_cast<int>(at_y);
  const int bottom = std::min(top + 1, image.height - 1);
  const auto column = [&](int x) { return (x + image.width) % image.width; };
  const double to_right = at_x - left;
  const double down = at_y - top;
  std::array<float, 3> out{};
  for (std::size_t c = 0; c < out.size(); ++c) {
    const auto along = [&](int y) {
      return static_cast<double>(image.at(column(left), y, c)) * (1 - to_right) +
             static_cast<double>(image.at(column(left + 1), y, c)) * to_right;
    };
    out.at(c) = static_cast<float>(along(top) * (1 - down) + along(bottom) * down);
  }
  return out;
}

// The number of texels by which the image moves to the right where the matrix turns it about Y by that many;
// else nothing.
std::optional<int> whole_shift(const TurnedEnvironment& map) {
  constexpr double kRounding = 1e-6;
  if (!(map.matrix(1, 1) > 1 - kRounding * kRounding)) return std::nullopt;
  // The middle of the image, local -Z, comes to lie at this share of the width.
  const Vec2d middle = scene::map_coordinates(transform_direction(map.matrix, {0, 0, -1}));
  const double texels = (middle.x - 0.5) * map.image.width;
  if (std::fabs(texels - std::round(texels)) > kRounding * map.image.width) return std::nullopt;
  return static_cast<int>(std::lround(texels));
}

}  // namespace

// Of an even sky the brightest texel is the mean; a lamp of five degrees that gives as much as all the rest
// is 500 times as bright.
bool has_sun(const scene::Scene& scene) {
  constexpr double kPeakOverMean = 1000;
  const auto image = tinted_map(scene);
  double sum = 0;
  double peak = 0;
  for (const float value : image.pixels) {
    sum += static_cast<double>(value);
    peak = std::max(peak, static_cast<double>(value));
  }
  return peak * static_cast<double>(image.pixels.size()) > kPeakOverMean * sum;
}

TurnedEnvironment turned_environment(const scene::Scene& scene) {
  TurnedEnvironment out{tinted_map(scene), scene.environment.map.value().matrix};
  if (determinant3(out.matrix) > 0) return out;
  mirror_columns(out.image);
  out.matrix = out.matrix * scaling({-1, 1, 1});
  return out;
}

image::Image environment_in_world(const scene::Scene& scene) {
  const TurnedEnvironment map = turned_environment(scene);
  const auto shift = whole_shift(map);
  const int factor = shift ? 1 : 2;
  auto out = image::make_image(map.image.width * factor, map.image.height * factor, {"R", "G", "B"});
  const Mat4 back = inverse(map.matrix).value();
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      if (shift) {
        const int from = ((x - *shift) % out.width + out.width) % out.width;
        for (std::size_t c = 0; c < 3; ++c) out.at(x, y, c) = map.image.at(from, y, c);
        continue;
      }
      const Vec3d d = scene::map_direction({(x + 0.5) / out.width, 1 - (y + 0.5) / out.height});
      const auto value = looked_up(map.image, scene::map_coordinates(transform_direction(back, d)));
      for (std::size_t c = 0; c < 3; ++c) out.at(x, y, c) = value.at(c);
    }
  return out;
}

}  // namespace orbs::adapters

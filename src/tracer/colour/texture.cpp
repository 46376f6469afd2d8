#include "tracer/colour/texture.h"

#include "base/error.h"
#include "image/colour.h"
#include "image/image_io.h"
#include "tracer/numeric_fault.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace orbs::tracer {

TexelGrid load_texels(const scene::Texture& texture, Texels texels) {
  const auto encoded =
      texture.encoding == scene::Encoding::Linear ? image::Encoded::Numbers : image::Encoded::Srgb;
  auto image = with_note(fmt::format("loading texture '{}'", texture.name),
                         [&] { return image::read_linear_rgb(texture.file, encoded); });
  if (texels == Texels::AsStored && image::is_ldr_file(texture.file))
    for (float& value : image.pixels) value = image::srgb_encode(value);
  TexelGrid grid{image.width, image.height, {}, texture.wrap_u, texture.wrap_v, {}};
  grid.texels.reserve(image.pixel_count());
  Vec3d sum;
  for (int y = image.height - 1; y >= 0; --y)
    for (int x = 0; x < image.width; ++x) {
      const Vec3f texel{image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
      grid.texels.push_back(texel);
      sum += cast<double>(texel);
    }
  grid.average = cast<float>(sum / static_cast<double>(image.pixel_count()));
  grid.is_nearest = texture.filter == scene::Filter::Nearest;
  grid.is_plain =
      !grid.is_nearest && texture.wrap_u != scene::Wrap::Mirror && texture.wrap_v != scene::Wrap::Mirror;
  return grid;
}

namespace {

struct Neighbours {
  int low = 0;
  int high = 0;
  float share_of_high = 0;
};

Neighbours neighbours(float coordinate, int size, scene::Wrap wrap) {
  // Whole periods are subtracted before scaling, so that u = 1000.25 keeps the digits of its fraction.
  const float local = wrap == scene::Wrap::Repeat ? coordinate - std::floor(coordinate) : coordinate;
  const float at = local * static_cast<float>(size) - 0.5F;
  // Beyond these bounds the result is clamped anyway.
  const float bounded = std::min(std::max(at, -1.0F), static_cast<float>(size));
  const float floor = std::floor(bounded);
  const int low = static_cast<int>(floor);
  if (wrap == scene::Wrap::Clamp)
    return {std::clamp(low, 0, size - 1), std::clamp(low + 1, 0, size - 1), bounded - floor};
  return {low < 0 ? low + size : low, low + 1 >= size ? low + 1 - size : low + 1, bounded - floor};
}

// The coordinate without whole periods, as above, in texels.
float texels_along(float coordinate, int size, scene::Wrap wrap) {
  float local = coordinate;
  if (wrap == scene::Wrap::Repeat) local -= std::floor(coordinate);
  if (wrap == scene::Wrap::Mirror) local -= 2 * std::floor(coordinate / 2);
  return local * static_cast<float>(size);
}

// The texel that stands at an index of any size, see scene::Wrap.
int wrapped(float index, int size, scene::Wrap wrap) {
  // Beyond these bounds lie clamped coordinates alone: others are within their period of 2 size at most.
  const int i = static_cast<int>(std::min(std::max(index, -1.0F), 2 * static_cast<float>(size)));
  if (wrap == scene::Wrap::Clamp) return std::clamp(i, 0, size - 1);
  if (wrap == scene::Wrap::Repeat) return (i + size) % size;
  const int in_period = (i + 2 * size) % (2 * size);
  return in_period < size ? in_period : 2 * size - 1 - in_period;
}

Neighbours special_neighbours(float coordinate, int size, scene::Wrap wrap, bool is_nearest) {
  const float at = texels_along(coordinate, size, wrap);
  if (is_nearest) {
    const int texel = wrapped(std::floor(at), size, wrap);
    return {texel, texel, 0};
  }
  const float low = std::floor(at - 0.5F);
  const float share = std::isfinite(low) ? at - 0.5F - low : 0;
  return {wrapped(low, size, wrap), wrapped(low + 1, size, wrap), share};
}

}  // namespace

Vec3f lookup(const TexelGrid& grid, Vec2f uv) {
  // A texture matrix can move coordinates out of the range of floats. There is no texel then, and the sample
  // is counted as bad.
  if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) {
    constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
    return {kNone, kNone, kNone};
  }
  const Neighbours x = grid.is_plain ? neighbours(uv.x, grid.width, grid.wrap_u)
                                     : special_neighbours(uv.x, grid.width, grid.wrap_u, grid.is_nearest);
  const Neighbours y = grid.is_plain ? neighbours(uv.y, grid.height, grid.wrap_v)
                                     : special_neighbours(uv.y, grid.height, grid.wrap_v, grid.is_nearest);
  const auto texel = [&](int column, int row) {
    return grid.texels[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.width) +
                       static_cast<std::size_t>(column)];
  };
  const Vec3f bottom = texel(x.low, y.low) * (1 - x.share_of_high) + texel(x.high, y.low) * x.share_of_high;
  const Vec3f top = texel(x.low, y.high) * (1 - x.share_of_high) + texel(x.high, y.high) * x.share_of_high;
  return bottom * (1 - y.share_of_high) + top * y.share_of_high;
}

Vec2f slope_of_red(const TexelGrid& grid, Vec2f uv) {
  if (!std::isfinite(uv.x) || !std::isfinite(uv.y) || grid.is_nearest) return {};
  const Neighbours x = special_neighbours(uv.x, grid.width, grid.wrap_u, false);
  const Neighbours y = special_neighbours(uv.y, grid.height, grid.wrap_v, false);
  const auto red = [&](int column, int row) {
    return grid
        .texels[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.width) +
                static_cast<std::size_t>(column)]
        .x;
  };
  const float low_row = red(x.high, y.low) - red(x.low, y.low);
  const float high_row = red(x.high, y.high) - red(x.low, y.high);
  const float low_column = red(x.low, y.high) - red(x.low, y.low);
  const float high_column = red(x.high, y.high) - red(x.high, y.low);
  const auto between = [](float a, float b, float share) { return a + (b - a) * share; };
  // A mirrored image runs backwards in every second period, which `low` and `high` follow by themselves.
  return {static_cast<float>(grid.width) * between(low_row, high_row, y.share_of_high),
          static_cast<float>(grid.height) * between(low_column, high_column, x.share_of_high)};
}

UvMap uv_map(const scene::TextureUse& use, const scene::Texture& texture) {
  const bool keeps = has_fault(NumericFault::TexturePeriodsKept);
  const Mat4 m = keeps ? use.matrix : scene::without_repetitions(use.matrix, texture);
  const auto f = [&](std::size_t row, std::size_t column) { return static_cast<float>(m(row, column)); };
  return {{f(0, 0), f(0, 1), f(0, 3), f(1, 0), f(1, 1), f(1, 3)}, use.uv_set};
}

}  // namespace orbs::tracer

#include "adapters/mirrored_image.h"

#include <utility>

namespace orbs::adapters {

bool is_mirrored(const scene::Texture& texture) {
  return texture.wrap_u == scene::Wrap::Mirror || texture.wrap_v == scene::Wrap::Mirror;
}

scene::Texture unmirrored(scene::Texture texture) {
  for (auto* wrap : {&texture.wrap_u, &texture.wrap_v})
    if (*wrap == scene::Wrap::Mirror) *wrap = scene::Wrap::Repeat;
  return texture;
}

Vec2d unmirrored_uv_scale(const scene::Texture& texture) {
  const auto scale = [](scene::Wrap wrap) { return wrap == scene::Wrap::Mirror ? 0.5 : 1.0; };
  return {scale(texture.wrap_u), scale(texture.wrap_v)};
}

// v runs up from the bottom row: the given rows stay at the bottom, and rows are stored from the top.
image::Image with_mirror_images(const image::Image& given, const scene::Texture& texture) {
  const bool wide = texture.wrap_u == scene::Wrap::Mirror;
  const bool high = texture.wrap_v == scene::Wrap::Mirror;
  auto out = image::make_image(given.width * (wide ? 2 : 1), given.height * (high ? 2 : 1), given.channels);
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      const int column = x < given.width ? x : 2 * given.width - 1 - x;
      const int from_bottom = out.height - 1 - y;
      const int row =
          from_bottom < given.height ? given.height - 1 - from_bottom : from_bottom - given.height;
      for (std::size_t c = 0; c < given.channels.size(); ++c) out.at(x, y, c) = given.at(column, row, c);
    }
  return out;
}

}  // namespace orbs::adapters

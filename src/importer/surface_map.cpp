#include "importer/surface_map.h"

#include "image/image_io.h"
#include "importer/textures.h"

#include <algorithm>
#include <cmath>

namespace orbs::importer {

namespace {

// Steps of the texture's values. A finer one makes more materials: 9 times 33 at most of each.
constexpr double kMetallicSteps = 8;
constexpr double kRoughnessSteps = 32;

double in_steps(double value, double steps) { return std::round(value * steps) / steps; }

bool is_even(const image::Image& picture, std::size_t channel) {
  for (std::size_t i = channel; i < picture.pixels.size(); i += picture.channel_count())
    if (picture.pixels[i] != picture.pixels[channel]) return false;
  return true;
}

// The texel of a row of `size` that a coordinate lies in.
int texel(double coordinate, int size, scene::Wrap wrap) {
  const double length = wrap == scene::Wrap::Mirror ? 2 : 1;
  double within = coordinate - length * std::floor(coordinate / length);
  if (wrap == scene::Wrap::Clamp) within = std::min(std::max(coordinate, 0.0), 1.0);
  if (within > 1) within = 2 - within;
  return std::min(static_cast<int>(within * size), size - 1);
}

}  // namespace

std::optional<SurfaceMap> SurfaceMap::of(Import& import, int index) {
  if (index < 0) return std::nullopt;
  const auto& material = item(import.source, import.source.model.materials, index, "material", "a mesh");
  const auto& info = material.pbrMetallicRoughness.metallicRoughnessTexture;
  if (info.index < 0) return std::nullopt;
  const auto where = place("material", material.name, static_cast<std::size_t>(index));
  auto picture = read_picture(import, info.index, where);
  if (!picture) return std::nullopt;
  SurfaceMap map;
  map.channels_ = image::texture_channels(*picture);
  map.picture_ = std::move(*picture);
  map.matrix_ = texture_matrix(import.source, info, where);
  map.coordinates_ = coordinate_set(info);
  const auto& textures = import.source.model.textures;
  map.sampled_ = sampled(import.source, textures[static_cast<std::size_t>(info.index)].sampler, where);
  map.is_even_ = is_even(map.picture_, map.channels_[1]) && is_even(map.picture_, map.channels_[2]);
  if (!map.is_even_)
    import.report.not_understood(
        "textures of metal and roughness",
        fmt::format("each triangle has its mean, in steps of 1/{} and 1/{}", kMetallicSteps, kRoughnessSteps),
        where);
  return map;
}

Shown SurfaceMap::shown(const std::array<Vec2f, 3>& corners, scene::RgbColour tint) const {
  if (is_even_) return {tint, picture_.pixels[channels_[2]], picture_.pixels[channels_[1]]};
  // The means of the 36 parts of equal area into which the triangle falls: no part is missed that a sixth of
  // an edge resolves.
  constexpr int kParts = 6;
  double metallic = 0;
  double roughness = 0;
  int count = 0;
  for (int i = 0; i < kParts; ++i)
    for (int j = 0; j < kParts - i; ++j)
      for (const double third : {1.0, 2.0}) {
        const double a = (i + third / 3) / kParts;
        const double b = (j + third / 3) / kParts;
        if (a + b >= 1) continue;
        const double c = 1 - a - b;
        const Vec3d uv =
            transform_point(matrix_, {a * corners[0].x + b * corners[1].x + c * corners[2].x,
                                      a * corners[0].y + b * corners[1].y + c * corners[2].y, 0});
        const int x = texel(uv.x, picture_.width, sampled_.wrap_u);
        const int y = picture_.height - 1 - texel(uv.y, picture_.height, sampled_.wrap_v);
        metallic += picture_.at(x, y, channels_[2]);
        roughness += picture_.at(x, y, channels_[1]);
        ++count;
      }
  return {tint, in_steps(metallic / count, kMetallicSteps), in_steps(roughness / count, kRoughnessSteps)};
}

}  // namespace orbs::importer

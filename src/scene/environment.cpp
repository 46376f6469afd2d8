#include "scene/environment.h"

#include "base/nth.h"
#include "json/writer.h"
#include "scene/load/spectra.h"

#include <cmath>
#include <numbers>

namespace orbs::scene {

namespace {

constexpr double kTwoPi = 2 * std::numbers::pi;

// Sums of products of sines and cosines come out some 1e-16 from 0 and 1.
constexpr double kMatrixRounding = 1e-9;

// What keeps all lengths and angles, and moves nothing.
bool turns_only(const Mat4& matrix) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (matrix(i, 3) != 0) return false;
    for (std::size_t k = 0; k < 3; ++k) {
      double product = 0;
      for (std::size_t row = 0; row < 3; ++row) product += matrix(row, i) * matrix(row, k);
      if (!(std::fabs(product - (i == k ? 1 : 0)) <= kMatrixRounding)) return false;
    }
  }
  return true;
}

EnvironmentMap load_map(json::ObjectReader& in, const Names& textures) {
  EnvironmentMap map{textures.find(in, "map"), load_matrix(in, "matrix")};
  if (!turns_only(map.matrix))
    in.fail("matrix",
            "must turn or mirror the map and do nothing else: it lies infinitely far away, where no "
            "scale and no translation changes anything");
  return map;
}

}  // namespace

Vec2d map_coordinates(Vec3d direction) {
  const Vec3d d = normalised(direction);
  return {0.5 + std::atan2(d.x, -d.z) / kTwoPi,
          0.5 + std::atan2(d.y, std::hypot(d.x, d.z)) / std::numbers::pi};
}

Vec3d map_direction(Vec2d uv) {
  const double longitude = (uv.x - 0.5) * kTwoPi;
  const double latitude = (uv.y - 0.5) * std::numbers::pi;
  return {std::cos(latitude) * std::sin(longitude), std::sin(latitude),
          -std::cos(latitude) * std::cos(longitude)};
}

Environment load_environment(json::ObjectReader& in, const Names& textures, const SpectralData& data) {
  if (!in.has("environment")) return {};
  const auto colour_of = [&](json::ObjectReader& reader, const char* key) {
    const Colour colour = load_radiance(reader, key, data);
    return Environment{.radiance = colour.rgb, .spectrum = colour.spectrum};
  };
  if (in.holds_array("environment")) return colour_of(in, "environment");
  auto entry = in.object("environment", "[r, g, b], a spectrum, or an object with a radiance or a map");
  if (entry.has("spectrum")) return colour_of(in, "environment");
  const bool has_map = entry.has("map");
  Environment out{.radiance = {1, 1, 1}};
  if (entry.has("radiance") || !has_map) out = colour_of(entry, "radiance");
  if (has_map) out.map = load_map(entry, textures);
  if (has_map && out.spectrum) entry.fail("map", "goes with a radiance [r, g, b], not with a spectrum");
  out.visible_to_camera = entry.boolean_or("visible_to_camera", true);
  entry.finish();
  return out;
}

void write_environment(json::Writer& out,
                       const SpectrumList& spectra,
                       const std::vector<Texture>& textures,
                       const Environment& environment) {
  if (!environment.map && environment.visible_to_camera) {
    write_colour(out, spectra, "environment", environment.radiance, environment.spectrum);
    return;
  }
  out.key("environment").begin_object();
  write_colour(out, spectra, "radiance", environment.radiance, environment.spectrum);
  if (const auto& map = environment.map) {
    out.member("map", nth(textures, map->texture).name);
    out.key("matrix").numbers(map->matrix.m);
  }
  if (!environment.visible_to_camera) out.member("visible_to_camera", false);
  out.end_object();
}

}  // namespace orbs::scene

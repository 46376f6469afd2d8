#pragma once

#include "base/matrix.h"
#include "scene/colour.h"
#include "scene/texture.h"

#include <optional>
#include <vector>

namespace orbs::json {
class ObjectReader;
class Writer;
}  // namespace orbs::json

namespace orbs::scene {

class Names;
struct SpectralData;

/// A latitude-longitude image that multiplies the radiance of the environment. `matrix` turns or mirrors it
/// and does nothing else: with d' = M^-1 d, u = 1/2 + atan2(d'.x, -d'.z) / (2 pi) and v = 1/2 + asin(d'.y) /
/// pi, so that the middle of the image lies towards -z, its right quarter towards +x, its top towards +y.
/// Texels are interpolated bilinearly between their centres; u wraps, and beyond the outermost rows v stays
/// at their values, however the texture wraps and filters where a material shows it.
struct EnvironmentMap {
  int texture = 0;  // index into Scene::textures
  Mat4 matrix;
  bool operator==(const EnvironmentMap&) const = default;
};

/// What rays see that meet no surface, from infinitely far away.
struct Environment {
  RgbColour radiance;
  std::optional<SpectrumUse> spectrum = {};
  std::optional<EnvironmentMap> map = {};
  /// False: black to rays that come from the camera and have met nothing. All else sees it.
  bool visible_to_camera = true;
  bool operator==(const Environment&) const = default;
};

inline bool shines(const Environment& environment) { return !(environment.radiance == RgbColour{}); }

/// Where a direction of the map's own frame lies in the image: u and v in [0, 1].
Vec2d map_coordinates(Vec3d direction);
/// The unit direction of the map's own frame in which this place of the image lies.
Vec3d map_direction(Vec2d uv);

/// "environment": a colour, a spectrum, or an object with more. Black when absent. InputError at the key that
/// is wrong.
Environment load_environment(json::ObjectReader& in, const Names& textures, const SpectralData& data);
void write_environment(json::Writer& out,
                       const SpectrumList& spectra,
                       const std::vector<Texture>& textures,
                       const Environment& environment);

}  // namespace orbs::scene

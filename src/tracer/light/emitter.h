#pragma once

#include "scene/lights/ies.h"
#include "tracer/colour/colour.h"
#include "tracer/light/directional_emitter.h"
#include "tracer/light/disk_emitter.h"
#include "tracer/light/environment_emitter.h"
#include "tracer/light/point_emitter.h"
#include "tracer/light/rect_emitter.h"
#include "tracer/light/sphere_emitter.h"
#include "tracer/light/spot_emitter.h"
#include "tracer/light/triangle_emitter.h"

#include <array>
#include <optional>
#include <variant>
#include <vector>

/// Emitters: the lights of the scene and the triangles of emissive meshes. Lights are in double: of a
/// lamp that is 10^5 times as large as the height of a point below it, floats leave that height two digits.
namespace orbs::tracer {

/// Variants of kinds of emitters only, see EmitterType.
template <EmitterType... Types>
using EmitterVariant = std::variant<Types...>;

using EmitterShape = EmitterVariant<RectEmitter,
                                    DiskEmitter,
                                    SphereEmitter,
                                    PointEmitter,
                                    SpotEmitter,
                                    DirectionalEmitter,
                                    EnvironmentEmitter>;

/// A light of the scene; some kinds have no area.
struct AreaLight {
  EmitterShape shape;
  Radiance radiance;  // or intensity, or irradiance
  Vec3f reflectance;  // Lambertian, of the emitting side
  std::optional<scene::IesUse> ies;
  std::array<Vec3f, 3> ies_axes;  // unit world directions of the profile's local x, y, z
  Vec3f centre;
  bool is_vast = false;  // much larger than all else, as a mesh with exact positions
};

/// The functions of EmitterType, of any kind.
std::optional<EmitterPoint> sample_towards(const EmitterShape& shape, Vec3f from, float u, float v);
float pdf_towards(const EmitterShape& shape, Vec3f from, Vec3f position);
EmittingPoint point_on(const EmitterShape& shape, float u, float v);
float pdf_area(const EmitterShape& shape, Vec3f position);
Vec3f normal_of(const EmitterShape& shape, Vec3f position);
float rounding_of(const EmitterShape& shape);
float area_of(const EmitterShape& shape);
bool has_area(const EmitterShape& shape);

/// Radiance that the light emits from `position` towards `to`, with its IES profile; zero on the dark side.
Radiance radiance_towards(const AreaLight& light, Vec3f position, Vec3f to);

/// Bounds of all emitters, the lights first, with the powers (radiance times area) of EmitterTable::build.
std::vector<LightBounds> bounds_of(const std::vector<AreaLight>& lights,
                                   const std::vector<TriangleEmitter>& triangles,
                                   const std::vector<float>& powers);

}  // namespace orbs::tracer

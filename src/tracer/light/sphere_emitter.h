#pragma once

#include "scene/lights/sphere.h"
#include "tracer/light/emitter_type.h"

#include <array>

namespace orbs::tracer {

struct CurvedSurface;

/// Image of the unit sphere under p -> centre + axes p: a sphere, or an ellipsoid if the matrix of the light
/// scales unevenly.
struct SphereEmitter {
  static constexpr bool kHasArea = true;
  Vec3d centre;
  std::array<Vec3d, 3> axes{};     // images of the unit axes
  std::array<Vec3d, 3> inverse{};  // rows of the inverse map
  double determinant = 1;          // |det axes|
  float area = 0;                  // of the sphere of equal volume; used for selection only
};

SphereEmitter make_emitter(const scene::SphereShape& sphere, const Mat4& matrix, Vec3d normal);
CurvedSurface surface_of(const SphereEmitter& sphere);
std::optional<EmitterPoint> sample_towards(const SphereEmitter& sphere, Vec3f from, float u, float v);
float pdf_towards(const SphereEmitter& sphere, Vec3f from, Vec3f position);
EmittingPoint point_on(const SphereEmitter& sphere, float u, float v);
float pdf_area(const SphereEmitter& sphere, Vec3f position);
Vec3f normal_of(const SphereEmitter& sphere, Vec3f position);
bool shows_bright_side(const SphereEmitter& sphere, Vec3f position, Vec3f to_viewer);
float rounding_of(const SphereEmitter& sphere);
LightBounds bounds_of(const SphereEmitter& sphere, float power);

}  // namespace orbs::tracer

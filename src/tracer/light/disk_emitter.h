#pragma once

#include "scene/lights/disk.h"
#include "tracer/light/emitter_type.h"

namespace orbs::tracer {

struct CurvedSurface;

/// Ellipse centre + s a + t b with s^2 + t^2 <= 1 that emits to the side of `normal`.
struct DiskEmitter {
  static constexpr bool kHasArea = true;
  Vec3d centre;
  Vec3d a;
  Vec3d b;
  Vec3d normal;
  float area = 0;
};

DiskEmitter make_emitter(const scene::DiskShape& disk, const Mat4& matrix, Vec3d normal);
CurvedSurface surface_of(const DiskEmitter& disk);
std::optional<EmitterPoint> sample_towards(const DiskEmitter& disk, Vec3f from, float u, float v);
float pdf_towards(const DiskEmitter& disk, Vec3f from, Vec3f position);
EmittingPoint point_on(const DiskEmitter& disk, float u, float v);
float pdf_area(const DiskEmitter& disk, Vec3f position);
Vec3f normal_of(const DiskEmitter& disk, Vec3f position);
bool shows_bright_side(const DiskEmitter& disk, Vec3f position, Vec3f to_viewer);
float rounding_of(const DiskEmitter& disk);
LightBounds bounds_of(const DiskEmitter& disk, float power);

}  // namespace orbs::tracer

#pragma once

#include "scene/lights/rect.h"
#include "tracer/light/emitter_type.h"

#include <array>

namespace orbs::tracer {

/// Parallelogram centre +- a +- b that emits to the side of `normal`.
struct RectEmitter {
  static constexpr bool kHasArea = true;
  Vec3d centre;
  Vec3d a;  // half the width
  Vec3d b;  // half the length
  Vec3d normal;
  float area = 0;
  bool is_orthogonal = false;
};

/// Two triangles: the corners 0, 1, 2 and 0, 2, 3.
struct Quad {
  std::array<Vec3d, 4> corners;
};

RectEmitter make_emitter(const scene::RectShape& rect, const Mat4& matrix, Vec3d normal);
Quad surface_of(const RectEmitter& rect);
std::optional<EmitterPoint> sample_towards(const RectEmitter& rect, Vec3f from, float u, float v);
float pdf_towards(const RectEmitter& rect, Vec3f from, Vec3f position);
EmittingPoint point_on(const RectEmitter& rect, float u, float v);
float pdf_area(const RectEmitter& rect, Vec3f position);
Vec3f normal_of(const RectEmitter& rect, Vec3f position);
bool shows_bright_side(const RectEmitter& rect, Vec3f position, Vec3f to_viewer);
float rounding_of(const RectEmitter& rect);
LightBounds bounds_of(const RectEmitter& rect, float power);

}  // namespace orbs::tracer

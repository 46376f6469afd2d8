#pragma once

#include "tracer/light/emitter_type.h"

#include <array>

namespace orbs::tracer {

/// Triangle of an emissive mesh; emits from both sides.
struct TriangleEmitter {
  Vec3f corner;
  Vec3f edge1;
  Vec3f edge2;
  Vec3f normal;
  float area = 0;
  std::array<Vec2f, 3> uvs;
  int material = 0;
};

std::optional<EmitterPoint> sample_towards(const TriangleEmitter& triangle,
                                           Vec3f from,
                                           Vec2f uv,
                                           Vec2f& texture_uv);
/// Each side is sampled with probability 1/2, which is part of the pdf.
EmittingPoint point_on(const TriangleEmitter& triangle, float u, float v, float side);
float rounding_of(const TriangleEmitter& triangle);
LightBounds bounds_of(const TriangleEmitter& triangle, float power);

}  // namespace orbs::tracer

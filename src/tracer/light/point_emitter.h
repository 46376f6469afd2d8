#pragma once

#include "scene/lights/point.h"
#include "tracer/light/emitter_without_area.h"

namespace orbs::tracer {

struct PointEmitter {
  static constexpr bool kHasArea = false;
  Vec3f position;
  float area = 1;  // the power of a point is its intensity (LightBounds::power)
};

PointEmitter make_emitter(const scene::PointShape& point, const Mat4& matrix, Vec3d normal);
std::optional<EmitterPoint> sample_towards(const PointEmitter& point, Vec3f from, float u, float v);
LightBounds bounds_of(const PointEmitter& point, float power);

}  // namespace orbs::tracer

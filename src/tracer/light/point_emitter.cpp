#include "tracer/light/point_emitter.h"

namespace orbs::tracer {

PointEmitter make_emitter(const scene::PointShape&, const Mat4& matrix, Vec3d) {
  return {.position = cast<float>(transform_point(matrix, {}))};
}

std::optional<EmitterPoint> sample_towards(const PointEmitter& point, Vec3f from, float, float) {
  return sample_point(from, point.position);
}

LightBounds bounds_of(const PointEmitter& point, float power) { return point_bounds(point.position, power); }

}  // namespace orbs::tracer

#include "tracer/light/directional_emitter.h"

namespace orbs::tracer {

namespace {

// In radii of what is lit. Of two places in the sphere, one is two radii behind the other at most, so that a
// shadow ray of this length has left the sphere. Its end is rounded to 2^-20 radii, 2^-24 of its length. At
// this distance a point light would light the sphere evenly to a factor of (17 / 15)^2 = 1.28, as which the
// selection among several lights counts this one.
constexpr float kReach = 16;

}  // namespace

float reach(const DirectionalEmitter& light) { return kReach * light.radius; }

DirectionalEmitter make_emitter(const scene::DirectionalShape&, const Mat4& matrix, Vec3d) {
  return {.direction = cast<float>(normalised(transform_direction(matrix, {0, -1, 0})))};
}

void set_lit_sphere(DirectionalEmitter& light, Vec3d centre, double radius) {
  light.centre = cast<float>(centre);
  light.radius = static_cast<float>(radius);
  light.area = light.radius * light.radius;
}

std::optional<EmitterPoint> sample_towards(const DirectionalEmitter& light, Vec3f from, float, float) {
  return EmitterPoint{from - light.direction * reach(light), light.direction, 1, 0};
}

// The box holds the samples of all points of the sphere.
LightBounds bounds_of(const DirectionalEmitter& light, float power) {
  const Vec3f half{light.radius, light.radius, light.radius};
  LightBounds out = flat_bounds(light.centre - light.direction * reach(light), half, light.direction,
                                power * kReach * kReach);
  out.radius = light.radius;
  return out;
}

}  // namespace orbs::tracer

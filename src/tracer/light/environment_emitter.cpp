#include "tracer/light/environment_emitter.h"

#include <numbers>

namespace orbs::tracer {

namespace {

// In radii of what is lit, from any place in the sphere: as of DirectionalEmitter, a shadow ray of this
// length has left the sphere.
constexpr float kReach = 16;

}  // namespace

EnvironmentEmitter make_emitter(const EnvironmentMap& map, Vec3d centre, double radius) {
  EnvironmentEmitter out{.map = &map, .centre = cast<float>(centre), .radius = static_cast<float>(radius)};
  // An even sky lights a plane by pi times its radiance, which a point does at one radius by this intensity.
  out.area = static_cast<float>(std::numbers::pi * radius * radius * map.mean_luminance);
  return out;
}

std::optional<EmitterPoint> sample_towards(const EnvironmentEmitter& light, Vec3f from, float u, float v) {
  const Vec3f direction = sample_direction(*light.map, u, v);
  return EmitterPoint{from + direction * (kReach * light.radius), -direction, pdf_of(*light.map, direction),
                      0};
}

float pdf_towards(const EnvironmentEmitter& light, Vec3f from, Vec3f position) {
  return pdf_of(*light.map, position - from);
}

// The sphere holds all that is lit, so that no direction is known and the importance is the same everywhere.
LightBounds bounds_of(const EnvironmentEmitter& light, float power) {
  const float reach = kReach * light.radius;
  const Vec3f half{reach, reach, reach};
  return {.low = light.centre - half,
          .high = light.centre + half,
          .radius = reach,
          .axis = {0, 0, 1},
          .power = power * kReach * kReach};
}

}  // namespace orbs::tracer

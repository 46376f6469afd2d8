#pragma once

#include "tracer/light/emitter_without_area.h"
#include "tracer/light/environment_map.h"

namespace orbs::tracer {

/// An environment map as an emitter. No surface is hit there, but a ray that meets nothing sees it, so that
/// BSDF sampling finds it as well. What it lights lies in a sphere, and its light comes from beyond, as that
/// of DirectionalEmitter.
struct EnvironmentEmitter {
  static constexpr bool kHasArea = false;
  const EnvironmentMap* map = nullptr;  // World::environment_map
  Vec3f centre{};                       // of the sphere
  float radius = 0;
  float area = 0;  // it lights as a point whose intensity is this area times the radiance
};

EnvironmentEmitter make_emitter(const EnvironmentMap& map, Vec3d centre, double radius);
std::optional<EmitterPoint> sample_towards(const EnvironmentEmitter& light, Vec3f from, float u, float v);
float pdf_towards(const EnvironmentEmitter& light, Vec3f from, Vec3f position);
LightBounds bounds_of(const EnvironmentEmitter& light, float power);

}  // namespace orbs::tracer

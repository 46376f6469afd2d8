#pragma once

#include "scene/lights/directional.h"
#include "tracer/light/emitter_without_area.h"

namespace orbs::tracer {

/// Parallel light. What it lights lies in a sphere, and its light comes from beyond.
struct DirectionalEmitter {
  static constexpr bool kHasArea = false;
  Vec3f direction;  // unit, in which it shines
  Vec3f centre{};   // of the sphere
  float radius = 0;
  float area = 0;  // of the sphere's radius the square: it lights as a point of this intensity does there
};

DirectionalEmitter make_emitter(const scene::DirectionalShape& light, const Mat4& matrix, Vec3d normal);
/// Tells the light of the sphere that holds all surfaces and the camera.
void set_lit_sphere(DirectionalEmitter& light, Vec3d centre, double radius);
/// From a point of the sphere to where its light comes from, in metres.
float reach(const DirectionalEmitter& light);
std::optional<EmitterPoint> sample_towards(const DirectionalEmitter& light, Vec3f from, float u, float v);
LightBounds bounds_of(const DirectionalEmitter& light, float power);

}  // namespace orbs::tracer

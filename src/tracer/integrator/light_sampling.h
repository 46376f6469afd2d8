#pragma once

#include "tracer/world/surface.h"

#include <optional>

/// Light that a path meets, and light that it asks for.
namespace orbs::tracer {

/// Radiance that the surface met by the path's ray sends back along it, and the chance per solid angle that
/// light sampling at `sampled_from` would have picked that direction: at the ray's origin, or at its image
/// behind a flat mirror.
struct EmissionHit {
  Radiance radiance;
  float light_pdf = 0;
  bool is_emitter = false;  // light sampling and light paths know it; emissive spheres are found by chance
};

EmissionHit emission_at_light(const World& world, const RenderObject& object, const Ray& ray, const Hit& hit, Vec3f sampled_from);
EmissionHit emission_at_surface(const World& world, const SurfaceHit& surface, const Ray& ray, Vec3f sampled_from);

/// A light sample as the shading point sees it.
struct DirectLight {
  Radiance radiance;
  Vec3f position;  // on the light
  Vec3f target;    // end of the shadow ray, off the light's surface
  float pdf = 0;   // per solid angle, choice of the light included
  std::size_t emitter = 0;
};

std::optional<DirectLight> sample_light(const World& world, Vec3f from, float pick, float u, float v);

}  // namespace orbs::tracer

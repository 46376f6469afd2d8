#pragma once

#include "tracer/world/surface.h"

#include <optional>

/// Light that a path hits, and light sampling for next-event estimation.
namespace orbs::tracer {

/// Radiance that the surface hit by a ray emits back along it, and what MIS needs: the pdf per solid angle
/// with which light sampling at `sampled_from` picks that direction. `sampled_from` is the origin of the ray,
/// or its mirror image.
struct EmissionHit {
  Radiance radiance;
  float light_pdf = 0;
  bool is_light_sampled = false;  // by light sampling and light paths; false for emissive spheres
};

EmissionHit emission_at_light(
    const World& world, const RenderObject& object, const Ray& ray, const Hit& hit, Vec3f sampled_from);
EmissionHit emission_at_surface(const World& world,
                                const SurfaceHit& surface,
                                const EmissionMaterial& material,
                                const Ray& ray,
                                Vec3f sampled_from);

/// A point sampled on an emitter.
struct LightSample {
  Radiance radiance;  // towards the shading point
  Vec3f position;
  Vec3f target;   // end of the shadow ray, off the surface of the emitter
  float pdf = 0;  // per solid angle, selection of the emitter included
  std::size_t emitter = 0;
};

/// Whether there is next-event estimation at all.
inline bool samples_lights(const World& world) {
  return !world.emitters.empty() && world.direct_light != DirectLight::Bsdf;
}

/// Nothing if the sampled emitter does not shine on `from`. pick, u and v in [0, 1).
std::optional<LightSample> sample_light(const World& world, Vec3f from, float pick, float u, float v);

}  // namespace orbs::tracer

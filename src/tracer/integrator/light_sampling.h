#pragma once

#include "tracer/world/surface.h"

#include <optional>

/// Light that a path hits, and light sampling for next-event estimation.
namespace orbs::tracer {

/// Radiance that the surface hit by a ray emits back along it, and what MIS needs: the pdf per solid angle
/// with which light sampling at `sampled_from` picks that direction. Its position is the origin of the ray,
/// or its mirror image.
struct EmissionHit {
  Radiance radiance;
  float light_pdf = 0;
  bool is_light_sampled =
      false;  // by light sampling and light paths; false for spheres and shapes by formulas
  /// Density with which light paths start there (light_emission.h); 0 if camera paths connect to none.
  float emission_pdf = 0;
};

EmissionHit emission_at_light(const World& world,
                              const RenderObject& object,
                              const Ray& ray,
                              const Hit& hit,
                              const LightSampleContext& sampled_from);
/// What a ray in this direction sees that meets nothing, in a scene with an environment map.
EmissionHit emission_of_environment_map(const World& world,
                                        Vec3f direction,
                                        const LightSampleContext& sampled_from);
EmissionHit emission_at_surface(const World& world,
                                const SurfaceHit& surface,
                                const EmissionMaterial& material,
                                const Ray& ray,
                                const LightSampleContext& sampled_from);

/// A point sampled on an emitter.
struct LightSample {
  Radiance
      radiance;  // towards the shading point; over the pdf it is irradiance for lights without an area, too
  Vec3f position;
  Vec3f target;   // end of the shadow ray, off the surface of the emitter
  float pdf = 0;  // per solid angle, selection of the emitter included
  std::size_t emitter = 0;
  float emission_pdf = 0;  // as in EmissionHit
  bool can_be_hit = true;  // by BSDF sampling; not a light without an area
};

/// Whether there is next-event estimation at all. Lights without an area are found by nothing else.
inline bool samples_lights(const World& world) {
  return !world.emitters.empty() &&
         (world.direct_light != DirectLight::Bsdf || world.has_lights_without_area);
}

/// Probability with which light sampling for this point selects the emitter.
float selection_probability(const World& world, const LightSampleContext& at, std::size_t emitter);

/// Pdf per solid angle, selection included, with which sample_light samples this point of the emitter.
float light_pdf(const World& world, const LightSampleContext& at, std::size_t emitter, Vec3f position);

/// Nothing if the sampled emitter does not shine on the point. pick, u and v in [0, 1).
std::optional<LightSample> sample_light(
    const World& world, const LightSampleContext& at, double pick, float u, float v);

}  // namespace orbs::tracer

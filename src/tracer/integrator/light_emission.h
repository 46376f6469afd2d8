#pragma once

#include "tracer/world/world.h"

#include <array>

/// The start of a light path.
namespace orbs::tracer {

/// A ray from a point of an emitter towards the near-specular surfaces of the world (caustic_casters.h).
struct EmittedRay {
  Ray ray;
  std::size_t emitter = 0;
  Vec3f position;    // on the emitter
  Vec2f texture_uv;  // there, for emissive triangles
  /// Cosine over the product of all pdfs (selection of the emitter, area, solid angle); 0 for directions to
  /// the dark side. Of a light without an area, one over the pdf of its selection and its direction or, if
  /// that is its only one, its place.
  float weight = 0;
};

/// `at` samples the point on the emitter and the direction, `choice` the emitter, the caster, the side of a
/// triangle, and the digits of the first that no float holds; all numbers in [0, 1). The world must have
/// emitters and caustic_casters.
EmittedRay emit(const World& world, const std::array<float, 4>& at, const std::array<float, 4>& choice);

/// The same for a light vertex (light_vertex.h): by World::light_guides, and as far as these leave it open by
/// power and cosine. The weight is pi over the emission_pdf. The world must have emitters.
EmittedRay emit_towards_use(const World& world,
                            const std::array<float, 4>& at,
                            const std::array<float, 4>& choice);

/// Density per m^2 with which emit_towards_use starts light paths at this point of the emitter, on one of its
/// sides, times the density of their direction to `target` over that of a cosine lobe.
float emission_pdf(const World& world, std::size_t emitter, Vec3f position, Vec3f target);

/// Radiance that the emitter sends along the ray, which hits a surface at `target`.
Radiance emitted_towards(const World& world, const EmittedRay& emitted, Vec3f target);

}  // namespace orbs::tracer

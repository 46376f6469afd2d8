#include "tracer/integrator/light_emission.h"

#include "tracer/geometry/transforms.h"
#include "tracer/light/emitter.h"
#include "tracer/sampling/warps.h"
#include "tracer/world/surface.h"

namespace orbs::tracer {

namespace {

EmittingPoint point_on(const World& world,
                       std::size_t emitter,
                       const std::array<float, 4>& at,
                       const std::array<float, 4>& choice) {
  if (emitter >= world.emitters.light_count())
    return point_on(world.emitters.triangle(emitter), at[0], at[1], choice[2]);
  return point_on(world.lights[emitter].shape, at[0], at[1]);
}

EmittedRay emitted_ray(
    const World& world, std::size_t emitter, const EmittingPoint& from, Vec3f direction, float pdf) {
  EmittedRay out;
  out.emitter = emitter;
  out.position = from.position;
  out.texture_uv = from.texture_uv;
  // The origin is offset by the rounding error of the point and of the emitter's surface in the accelerator.
  out.ray = {from.position + from.normal * (2 * from.position_error), direction};
  const float cosine = dot(from.normal, direction);
  if (cosine > 0) out.weight = cosine / (world.emitters.probability(emitter) * from.pdf_area * pdf);
  return out;
}

}  // namespace

EmittedRay emit(const World& world, const std::array<float, 4>& at, const std::array<float, 4>& choice) {
  const std::size_t emitter = world.emitters.pick(choice[0]);
  const EmittingPoint from = point_on(world, emitter, at, choice);
  const auto to =
      sample_towards_casters(world.caustic_casters, from.position, from.normal, choice[1], at[2], at[3]);
  return emitted_ray(world, emitter, from, to.direction, to.pdf);
}

EmittedRay emit_by_cosine(const World& world,
                          const std::array<float, 4>& at,
                          const std::array<float, 4>& choice) {
  const std::size_t emitter = world.emitters.pick(choice[0]);
  const EmittingPoint from = point_on(world, emitter, at, choice);
  const Vec3f local = sample_cosine(at[2], at[3]);
  return emitted_ray(world, emitter, from, frame_around(from.normal).to_world(local), local.z * kInvPi);
}

float emission_pdf(const World& world, std::size_t emitter, Vec3f position) {
  const float selection = world.emitters.probability(emitter);
  if (emitter >= world.emitters.light_count())
    return selection * 0.5F / world.emitters.triangle(emitter).area;  // each of its sides
  return selection * pdf_area(world.lights[emitter].shape, position);
}

Radiance emitted_towards(const World& world, const EmittedRay& emitted, Vec3f target) {
  if (emitted.emitter < world.emitters.light_count())
    return radiance_towards(world.lights[emitted.emitter], emitted.position, target);
  const TriangleEmitter& triangle = world.emitters.triangle(emitted.emitter);
  return emitted_radiance(world, emission_of(world, triangle), emitted.texture_uv);
}

}  // namespace orbs::tracer

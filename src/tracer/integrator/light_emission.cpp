#include "tracer/integrator/light_emission.h"

#include "tracer/geometry/transforms.h"
#include "tracer/light/emission_without_area.h"
#include "tracer/light/emitter.h"
#include "tracer/sampling/warps.h"
#include "tracer/world/surface.h"

namespace orbs::tracer {

namespace {

EmittingPoint point_on(const World& world,
                       std::size_t emitter,
                       const std::array<float, 4>& at,
                       const std::array<float, 4>& choice) {
  if (const PluginShape* shape = plugin_emitter(world, emitter))
    return point_on(*shape, at[0], at[1], choice[2]);
  if (emitter >= world.emitters.light_count())
    return point_on(world.emitters.triangle(emitter), at[0], at[1], choice[2]);
  return point_on(world.lights[emitter].shape, at[0], at[1]);
}

// Per m^2, as point_on; of surfaces that shine to both sides, for each side.
float emitted_pdf_area(const World& world, std::size_t emitter, Vec3f position) {
  if (emitter < world.emitters.light_count()) return pdf_area(world.lights[emitter].shape, position);
  if (const PluginShape* shape = plugin_emitter(world, emitter)) return pdf_area(*shape, position);
  return 0.5F / world.emitters.triangle(emitter).area;
}

Vec3f emitter_normal(const World& world, std::size_t emitter, Vec3f position) {
  if (emitter < world.emitters.light_count()) return normal_of(world.lights[emitter].shape, position);
  if (const PluginShape* shape = plugin_emitter(world, emitter)) return normal_of(*shape, position);
  return world.emitters.triangle(emitter).normal;
}

EmittedRay emitted_ray(std::size_t emitter, const EmittingPoint& from, Vec3f direction, float weight) {
  EmittedRay out;
  out.emitter = emitter;
  out.position = from.position;
  out.texture_uv = from.texture_uv;
  // The origin is offset by the rounding error of the point and of the emitter's surface in the accelerator.
  out.ray = {from.position + from.normal * (2 * from.position_error), direction};
  if (dot(from.normal, direction) > 0) out.weight = weight;
  return out;
}

EmittedRay emit_without_area(const World& world,
                             std::size_t emitter,
                             const std::array<float, 4>& at,
                             float pick_caster) {
  const StartWithoutArea start =
      start_towards_casters(world.lights[emitter], world.caustic_casters, pick_caster, at[2], at[3]);
  EmittedRay out;
  out.emitter = emitter;
  out.position = start.position;
  out.ray = {start.position, start.direction};
  out.weight = 1 / (world.emitters.probability(emitter) * start.pdf);
  return out;
}

/// The start of a light path; `pdf` per m^2 of the emitter.
struct Start {
  std::size_t emitter = 0;
  Vec3f position;
  Vec3f normal;  // unit, on the side of the direction
  float pdf = 0;
  Vec3f direction;  // unit
};

// As emission_pdf. `chosen`: the guide that the direction was sampled by, if there is one.
float start_pdf(const World& world, const Start& start, const LightGuide* chosen) {
  const float unguided = start.pdf * world.emitters.probability(start.emitter);
  if (world.light_guides.empty()) return unguided;
  float sum = 0;
  for (const LightGuide& guide : world.light_guides)
    if (guide.emitter == start.emitter)
      sum += guide.probability *
             pdf_towards(guide.target, start.position, start.normal, start.direction, &guide == chosen);
  const float cosine = dot(start.normal, start.direction);
  return kUnguidedShare * unguided + (cosine > 0 ? start.pdf * sum * kPi / cosine : 0);
}

}  // namespace

EmittedRay emit(const World& world, const std::array<float, 4>& at, const std::array<float, 4>& choice) {
  const std::size_t emitter = world.emitters.pick(with_more_digits(choice[0], choice[3]));
  if (emitter < world.emitters.light_count() && !has_area(world.lights[emitter].shape))
    return emit_without_area(world, emitter, at, choice[1]);
  const EmittingPoint from = point_on(world, emitter, at, choice);
  const auto to =
      sample_towards_casters(world.caustic_casters, from.position, from.normal, choice[1], at[2], at[3]);
  const float cosine = dot(from.normal, to.direction);
  return emitted_ray(emitter, from, to.direction,
                     cosine / (world.emitters.probability(emitter) * from.pdf_area * to.pdf));
}

EmittedRay emit_towards_use(const World& world,
                            const std::array<float, 4>& at,
                            const std::array<float, 4>& choice) {
  const LightGuide* guide = pick_guide(world.light_guides, choice[1]);
  const std::size_t emitter =
      guide != nullptr ? guide->emitter : world.emitters.pick(with_more_digits(choice[0], choice[3]));
  const EmittingPoint from = point_on(world, emitter, at, choice);
  const Vec3f direction = guide != nullptr
                              ? direction_towards(guide->target, from.position, from.normal, at[2], at[3])
                              : frame_around(from.normal).to_world(sample_cosine(at[2], at[3]));
  const float pdf = start_pdf(world, {emitter, from.position, from.normal, from.pdf_area, direction}, guide);
  return emitted_ray(emitter, from, direction, kPi / pdf);
}

float emission_pdf(const World& world, std::size_t emitter, Vec3f position, Vec3f target) {
  const float pdf = emitted_pdf_area(world, emitter, position);
  if (world.light_guides.empty()) return pdf * world.emitters.probability(emitter);
  const Vec3f to_target = target - position;
  const bool is_light = emitter < world.emitters.light_count();
  Vec3f normal = emitter_normal(world, emitter, position);
  if (!is_light && dot(normal, to_target) < 0) normal = -normal;
  return start_pdf(world, {emitter, position, normal, pdf, normalised(to_target)}, nullptr);
}

Radiance emitted_towards(const World& world, const EmittedRay& emitted, Vec3f target) {
  if (emitted.emitter < world.emitters.light_count())
    return radiance_towards(world.lights[emitted.emitter], emitted.position, target);
  if (const PluginShape* shape = plugin_emitter(world, emitted.emitter)) return radiance_of(world, *shape);
  const TriangleEmitter& triangle = world.emitters.triangle(emitted.emitter);
  return emitted_radiance(world, emission_of(world, triangle), emitted.texture_uv);
}

}  // namespace orbs::tracer

#include "tracer/integrator/light_sampling.h"

#include "tracer/integrator/light_emission.h"
#include "tracer/light/emitter.h"
#include "tracer/numeric_fault.h"

#include <algorithm>
#include <cmath>

namespace orbs::tracer {

namespace {

// The shadow ray ends before the surface of the emitter, by a bound of the rounding errors. Twice the
// position error: that of the sampled point, and that of the surface as Embree intersects it. In half ulps of
// the length of the ray: 1 for its direction, 1 for the corners relative to its origin, 3 for each of the two
// dot products of the intersection test, which is 8, and doubled. Beside a large emitter this bound can
// exceed the height of `from` above it: the ray ends halfway at least, so that it does not end behind its
// origin.
Vec3f end_of_shadow_ray(const EmitterPoint& point, Vec3f from) {
  constexpr float kRayRounding = 16 * 0x1p-24F;
  constexpr float kEarly = 1e-3F;
  if (has_fault(NumericFault::ShadowRaysMeetLamp)) return point.position;
  if (has_fault(NumericFault::ShadowRaysEndEarly)) return point.position + (from - point.position) * kEarly;
  if (has_fault(NumericFault::ShadowRaysTooShort)) return from + (point.position - from) * kEarly;
  const float along_ray = kRayRounding * length(point.position - from);
  const float height = dot(point.normal, from - point.position);
  return point.position + point.normal * std::min(2 * point.position_error + along_ray, height / 2);
}

std::optional<SelectedEmitter> select_emitter(const World& world, const LightSampleContext& at, double pick) {
  if (!world.light_bvh.empty()) return world.light_bvh.select(at, pick);
  // For one emitter light_numbers draws no number to pick by.
  const std::size_t chosen = world.emitters.size() == 1 ? 0 : world.emitters.pick(pick);
  return SelectedEmitter{chosen, world.emitters.probability(chosen)};
}

float emission_pdf_if_connected(const World& world, std::size_t emitter, Vec3f position, Vec3f target) {
  return world.connects_light_vertices ? emission_pdf(world, emitter, position, target) : 0;
}

}  // namespace

float selection_probability(const World& world, const LightSampleContext& at, std::size_t emitter) {
  return world.light_bvh.empty() ? world.emitters.probability(emitter)
                                 : world.light_bvh.probability(at, emitter);
}

float light_pdf(const World& world, const LightSampleContext& at, std::size_t emitter, Vec3f position) {
  const float selection = selection_probability(world, at, emitter);
  if (emitter < world.emitters.light_count())
    return selection * pdf_towards(world.lights[emitter].shape, at.position, position);
  if (const PluginShape* shape = plugin_emitter(world, emitter))
    return selection * pdf_towards(*shape, at.position, position);
  const TriangleEmitter& triangle = world.emitters.triangle(emitter);
  const Vec3f d = position - at.position;
  const float distance2 = dot(d, d);
  const float cos_times_distance = std::abs(dot(triangle.normal, d));
  return cos_times_distance > 0
             ? selection * distance2 * std::sqrt(distance2) / (cos_times_distance * triangle.area)
             : 0;
}

std::optional<LightSample> sample_light(
    const World& world, const LightSampleContext& at, double pick, float u, float v) {
  const auto selected = select_emitter(world, at, pick);
  if (!selected) return std::nullopt;
  const auto [chosen, probability] = *selected;
  const Vec3f from = at.position;
  std::optional<EmitterPoint> point;
  Radiance radiance;
  bool can_be_hit = true;
  if (chosen < world.emitters.light_count()) {
    const AreaLight& light = world.lights[chosen];
    point = sample_towards(light.shape, from, u, v);
    if (point) radiance = radiance_towards(light, point->position, from);
    can_be_hit = !world.has_lights_without_area || has_area(light.shape) ||
                 static_cast<int>(chosen) == world.environment_light;
  } else if (const PluginShape* shape = plugin_emitter(world, chosen)) {
    point = sample_towards(*shape, from, u, v);
    if (point) radiance = radiance_of(world, *shape);
  } else {
    const TriangleEmitter& triangle = world.emitters.triangle(chosen);
    Vec2f uv;
    point = sample_towards(triangle, from, {u, v}, uv);
    if (point) radiance = emitted_radiance(world, emission_of(world, triangle), uv);
  }
  if (!point || is_dark(radiance) || !(point->pdf > 0)) return std::nullopt;
  if (can_be_hit && world.direct_light == DirectLight::Bsdf) return std::nullopt;
  return LightSample{radiance,
                     point->position,
                     end_of_shadow_ray(*point, from),
                     point->pdf * probability,
                     chosen,
                     emission_pdf_if_connected(world, chosen, point->position, from),
                     can_be_hit};
}

EmissionHit emission_at_light(const World& world,
                              const RenderObject& object,
                              const Ray& ray,
                              const Hit& hit,
                              const LightSampleContext& sampled_from) {
  const AreaLight& light = world.lights[object.light];
  const Vec3f position = ray.origin + ray.direction * hit.distance;
  const Radiance radiance = radiance_towards(light, position, ray.origin);
  if (is_dark(radiance)) return {};
  const bool is_of_another_point = has_fault(NumericFault::PdfOfAnotherPoint);
  const float pdf =
      selection_probability(world, sampled_from, object.light) *
      pdf_towards(light.shape, is_of_another_point ? ray.origin : sampled_from.position, position);
  return {radiance, pdf, world.emitters.probability(object.light) > 0,
          emission_pdf_if_connected(world, object.light, position, sampled_from.position)};
}

EmissionHit emission_of_environment_map(const World& world,
                                        Vec3f direction,
                                        const LightSampleContext& sampled_from) {
  const auto index = static_cast<std::size_t>(world.environment_light);
  const AreaLight& light = world.lights[index];
  const Radiance radiance{light.radiance.rgb * radiance_from(*world.environment_map, direction)};
  if (is_dark(radiance)) return {};
  const float pdf =
      selection_probability(world, sampled_from, index) * pdf_of(*world.environment_map, direction);
  return {radiance, pdf, world.emitters.probability(index) > 0};
}

EmissionHit emission_at_surface(const World& world,
                                const SurfaceHit& surface,
                                const EmissionMaterial& material,
                                const Ray& ray,
                                const LightSampleContext& sampled_from) {
  const Radiance radiance =
      emitted_radiance(world, material, texture_coordinates(world, surface, material.radiance.uv));
  // Spheres and shapes by formulas are not in the table of emitters.
  const int found = emitter_of(world, surface.hit.object, surface.hit.primitive);
  if (found < 0) return {.radiance = radiance};
  const auto emitter = static_cast<std::size_t>(found);
  if (plugin_emitter(world, emitter) != nullptr) {
    const Vec3f position = surface.point.position;
    return {radiance, light_pdf(world, sampled_from, emitter, position), true,
            emission_pdf_if_connected(world, emitter, position, sampled_from.position)};
  }
  const Vec3f d = surface.point.position - sampled_from.position;
  const float cosine = std::abs(dot(surface.point.geometric_normal, ray.direction));
  const float pdf_area =
      selection_probability(world, sampled_from, emitter) / world.emitters.triangle(emitter).area;
  return {radiance, cosine > 0 ? pdf_area * dot(d, d) / cosine : 0, true,
          emission_pdf_if_connected(world, emitter, surface.point.position, sampled_from.position)};
}

}  // namespace orbs::tracer

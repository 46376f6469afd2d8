#include "tracer/integrator/light_sampling.h"

#include "tracer/light/emitter_sampling.h"

namespace orbs::tracer {

namespace {

// The shadow ray ends before the surface of the emitter, by a bound of the rounding errors. Twice the
// position error: that of the sampled point, and that of the surface as Embree intersects it. In half ulps of
// the length of the ray: 1 for its direction, 1 for the corners relative to its origin, 3 for each of the two
// dot products of the intersection test, which is 8, and doubled.
Vec3f end_of_shadow_ray(const EmitterPoint& point, Vec3f from) {
  constexpr float kRayRounding = 16 * 0x1p-24F;
  const float along_ray = kRayRounding * length(point.position - from);
  return point.position + point.normal * (2 * point.position_error + along_ray);
}

}  // namespace

std::optional<LightSample> sample_light(const World& world, Vec3f from, float pick, float u, float v) {
  // For one emitter light_numbers draws no number to pick by.
  const std::size_t chosen = world.emitters.size() == 1 ? 0 : world.emitters.pick(pick);
  const float probability = world.emitters.probability(chosen);
  std::optional<EmitterPoint> point;
  Radiance radiance;
  if (chosen < world.emitters.light_count()) {
    const AreaLight& light = world.lights[chosen];
    point = sample_towards(light.shape, from, u, v);
    if (point) radiance = radiance_towards(light, point->position, from);
  } else {
    const TriangleEmitter& triangle = world.emitters.triangle(chosen);
    Vec2f uv;
    point = sample_towards(triangle, from, {u, v}, uv);
    if (point) radiance = emitted_radiance(world, emission_of(world, triangle), uv);
  }
  if (!point || is_dark(radiance) || !(point->pdf > 0)) return std::nullopt;
  return LightSample{radiance, point->position, end_of_shadow_ray(*point, from), point->pdf * probability,
                     chosen};
}

EmissionHit emission_at_light(
    const World& world, const RenderObject& object, const Ray& ray, const Hit& hit, Vec3f sampled_from) {
  const AreaLight& light = world.lights[object.light];
  const Vec3f position = ray.origin + ray.direction * hit.distance;
  const Radiance radiance = radiance_towards(light, position, ray.origin);
  if (is_dark(radiance)) return {};
  const float probability = world.emitters.probability(object.light);
  return {radiance, probability * pdf_towards(light.shape, sampled_from, position), probability > 0};
}

EmissionHit emission_at_surface(const World& world,
                                const SurfaceHit& surface,
                                const EmissionMaterial& material,
                                const Ray& ray,
                                Vec3f sampled_from) {
  const Vec3f d = surface.point.position - sampled_from;
  const float cosine = std::abs(dot(surface.point.geometric_normal, ray.direction));
  // Of emissive surfaces, only triangles are in the table of emitters.
  const bool is_light_sampled =
      material.emitter_pdf_per_area > 0 && !is_analytic(world.objects[surface.hit.object].kind);
  return {emitted_radiance(world, material, apply(material.radiance.uv, texture_coordinates(world, surface))),
          is_light_sampled && cosine > 0 ? material.emitter_pdf_per_area * dot(d, d) / cosine : 0,
          is_light_sampled};
}

}  // namespace orbs::tracer

#include "tracer/integrator/light_emission.h"

#include "tracer/geometry/frame.h"
#include "tracer/light/emitter_sampling.h"
#include "tracer/sampling/warps.h"
#include "tracer/world/surface.h"

namespace orbs::tracer {

namespace {

struct EmittingPoint {
  Vec3f position;
  Vec3f normal;        // unit, on the bright side
  float pdf_area = 0;  // per m^2, without the selection of the emitter
  float position_error = 0;
  Vec2f texture_uv;
};

EmittingPoint point_on(const RectEmitter& rect, float u, float v) {
  return {rect.centre + rect.a * (2 * u - 1) + rect.b * (2 * v - 1),
          rect.normal,
          1 / rect.area,
          rounding_of(rect),
          {}};
}

EmittingPoint point_on(const DiskEmitter& disk, float u, float v) {
  const Vec2f at = sample_disk(u, v);
  return {disk.centre + disk.a * at.x + disk.b * at.y, disk.normal, 1 / disk.area, rounding_of(disk), {}};
}

// Uniform on the unit sphere, then mapped to the ellipsoid. A linear map M takes a surface element dS with
// normal n to one of area |det M| |M^-T n| dS.
EmittingPoint point_on(const SphereEmitter& sphere, float u, float v) {
  const float z = 1 - 2 * u;
  const float r = std::sqrt(1 - z * z);  // z is exact and in [-1, 1], so this is not negative
  const float phi = 2 * kPi * v;
  const Vec3f p{r * std::cos(phi), r * std::sin(phi), z};
  const Vec3f normal = sphere.inverse[0] * p.x + sphere.inverse[1] * p.y + sphere.inverse[2] * p.z;
  const float stretch = length(normal);
  return {sphere.centre + sphere.axes[0] * p.x + sphere.axes[1] * p.y + sphere.axes[2] * p.z,
          normal / stretch,
          1 / (4 * kPi * sphere.determinant * stretch),
          rounding_of(sphere),
          {}};
}

// Both sides emit. Each is sampled with probability 1/2, which is part of the pdf.
EmittingPoint point_on(const TriangleEmitter& t, float u, float v, float side) {
  const Vec2f b = triangle_point({u, v});
  return {t.corner + t.edge1 * b.x + t.edge2 * b.y, side < 0.5F ? t.normal : -t.normal, 0.5F / t.area,
          rounding_of(t), interpolated_uv(t, b)};
}

EmittingPoint point_on(const World& world,
                       std::size_t emitter,
                       const std::array<float, 4>& at,
                       const std::array<float, 4>& choice) {
  if (emitter >= world.emitters.light_count())
    return point_on(world.emitters.triangle(emitter), at[0], at[1], choice[2]);
  return std::visit([&](const auto& shape) { return point_on(shape, at[0], at[1]); },
                    world.lights[emitter].shape);
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

float pdf_area(const RectEmitter& rect, Vec3f) { return 1 / rect.area; }
float pdf_area(const DiskEmitter& disk, Vec3f) { return 1 / disk.area; }

// As in point_on.
float pdf_area(const SphereEmitter& sphere, Vec3f position) {
  const Vec3f d = position - sphere.centre;
  const Vec3f p{dot(sphere.inverse[0], d), dot(sphere.inverse[1], d), dot(sphere.inverse[2], d)};
  const Vec3f normal = sphere.inverse[0] * p.x + sphere.inverse[1] * p.y + sphere.inverse[2] * p.z;
  return 1 / (4 * kPi * sphere.determinant * length(normal));
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
  return selection * std::visit([&](const auto& shape) { return pdf_area(shape, position); },
                                world.lights[emitter].shape);
}

Radiance emitted_towards(const World& world, const EmittedRay& emitted, Vec3f target) {
  if (emitted.emitter < world.emitters.light_count())
    return radiance_towards(world.lights[emitted.emitter], emitted.position, target);
  const TriangleEmitter& triangle = world.emitters.triangle(emitted.emitter);
  return emitted_radiance(world, emission_of(world, triangle), emitted.texture_uv);
}

}  // namespace orbs::tracer

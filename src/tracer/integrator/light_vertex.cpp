#include "tracer/integrator/light_vertex.h"

#include "base/random.h"
#include "tracer/integrator/path_batch.h"

#include <cmath>
#include <optional>

namespace orbs::tracer {

namespace {

constexpr std::uint64_t kLightVertexSeed = 0x2b0d1;  // separates their random numbers from those of camera paths

SampleBlock light_block(SampleBlock block) {
  return {static_cast<std::uint32_t>(mix(block.seed, kLightVertexSeed)), block.points};
}

std::optional<LightVertex> vertex_at(const World& world, const EmittedRay& emitted, const Hit& hit) {
  if (hit.object == kNoHit || world.objects[hit.object].kind == ObjectKind::Light) return std::nullopt;
  const SurfacePoint point = surface_point(world, emitted.ray, hit);
  const SurfaceMaterial& material = world.materials[static_cast<std::size_t>(point.material)];
  if (material.is_near_specular || std::holds_alternative<EmissionMaterial>(material.model))
    return std::nullopt;
  const Radiance radiance = emitted_towards(world, emitted, point.position);
  const float cosine = std::abs(dot(point.geometric_normal, emitted.ray.direction));
  if (is_dark(radiance) || !(cosine > 0)) return std::nullopt;
  return LightVertex{.point = point,
                     .hit = hit,
                     .to_light = -emitted.ray.direction,
                     .light_position = emitted.position,
                     .emitter = emitted.emitter,
                     .radiance = radiance,
                     .emission_pdf = kPi / emitted.weight,
                     .cos_light = cosine};
}

}  // namespace

void trace_light_vertices(LightVertexPool& pool, const World& world, std::span<const Sample> samples) {
  pool.vertices.clear();
  pool.rays.clear();
  pool.emitted.clear();
  pool.traced = samples.size();
  for (const Sample& sample : samples) {
    const SampleBlock block = light_block(sample.block);
    // These dimensions are free: the block is another one than the camera path's.
    pool.emitted.push_back(
        emit_by_cosine(world, draw(block, sample.index, 0, SampleDimension::PixelAndFirstLight),
                       draw(block, sample.index, 0, SampleDimension::LightPick)));
    pool.rays.push_back(pool.emitted.back().ray);
  }
  pool.hits.resize(pool.rays.size());
  pool.traversal_seconds = 0;
  timed_traversal(pool, [&] { world.accel->intersect(pool.rays, pool.hits); });
  for (std::size_t i = 0; i < pool.hits.size(); ++i)
    if (pool.emitted[i].weight > 0)
      if (const auto vertex = vertex_at(world, pool.emitted[i], pool.hits[i])) pool.vertices.push_back(*vertex);
  pool.first = static_cast<std::uint32_t>(
      mix(samples.front().block.seed, (std::uint64_t{samples.front().index} << 32) | kLightVertexSeed));
}

const LightVertex& vertex_for(const LightVertexPool& pool, std::uint32_t path, int bounce) {
  // A stride of about the golden ratio times 2^10 leads to other vertices at each bounce.
  constexpr std::uint64_t kStride = 633;
  const std::uint64_t index = std::uint64_t{pool.first} + path + kStride * static_cast<std::uint64_t>(bounce);
  return pool.vertices[index % pool.vertices.size()];
}

}  // namespace orbs::tracer

#include "tracer/integrator/light_vertex.h"

#include "base/nth.h"
#include "base/random.h"
#include "tracer/accel/timed_traversal.h"
#include "tracer/world/nearest_hits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace orbs::tracer {

namespace {

constexpr std::uint64_t kLightVertexSeed =
    0x2b0d1;  // separates their random numbers from those of camera paths

SampleBlock light_block(SampleBlock block) {
  return {static_cast<std::uint32_t>(mix(block.seed, kLightVertexSeed)), block.points};
}

std::optional<LightVertex> vertex_at(const World& world, const EmittedRay& emitted, const Hit& hit) {
  if (hit.object == kNoHit || world.objects[hit.object].kind == ObjectKind::Light) return std::nullopt;
  const SurfacePoint point = surface_point(world, emitted.ray, hit);
  const SurfaceMaterial& material = nth(world.materials, point.material);
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

// Four take most of the scatter of the distances and cosines; more cost more than they save (scene
// "secondary" of Smits and Jensen's).
constexpr std::size_t kCandidates = 4;

const LightVertex& candidate(const LightVertexPool& pool,
                             std::uint32_t path,
                             int bounce,
                             std::size_t number) {
  // Strides of about the golden ratio times 2^10 and 2^12 lead to other vertices at each bounce.
  constexpr std::uint64_t kBounceStride = 633;
  constexpr std::uint64_t kCandidateStride = 2531;
  const std::uint64_t index = std::uint64_t{pool.first} + path +
                              kBounceStride * static_cast<std::uint64_t>(bounce) + kCandidateStride * number;
  return pool.vertices[index % pool.vertices.size()];
}

}  // namespace

float unblocked_contribution(const LightVertex& vertex, const LightSampleContext& at) {
  const Vec3f d = vertex.point.position - at.position;
  const float distance2 = dot(d, d);
  if (!(distance2 > 0)) return 0;
  const float cos_here = at.normal == Vec3f{} ? std::sqrt(distance2) : dot(at.normal, d);
  const float cosines = std::max(0.0F, cos_here) * std::abs(dot(vertex.point.geometric_normal, d));
  const float brightness = largest(vertex.radiance.rgb) > 0 ? largest(vertex.radiance.rgb) : 1;
  return brightness * cosines / (distance2 * distance2 * vertex.emission_pdf * vertex.cos_light);
}

void trace_light_vertices(LightVertexPool& pool, const World& world, std::span<const Sample> samples) {
  pool.vertices.clear();
  pool.rays.clear();
  pool.emitted.clear();
  pool.traced = samples.size();
  for (const Sample& sample : samples) {
    const SampleBlock block = light_block(sample.block);
    // These dimensions are free: the block is another one than the camera path's.
    pool.emitted.push_back(emit_towards_use(world,
                                            draw(block, sample.index, 0, SampleDimension::PixelAndFirstLight),
                                            draw(block, sample.index, 0, SampleDimension::LightPick)));
    pool.rays.push_back(pool.emitted.back().ray);
  }
  pool.hits.resize(pool.rays.size());
  pool.traversal_seconds = 0;
  timed_traversal(pool, [&] { nearest_hits(world, pool.rays, pool.hits); });
  for (std::size_t i = 0; i < pool.hits.size(); ++i)
    if (pool.emitted[i].weight > 0)
      if (const auto vertex = vertex_at(world, pool.emitted[i], pool.hits[i]))
        pool.vertices.push_back(*vertex);
  pool.first = static_cast<std::uint32_t>(
      mix(samples.front().block.seed, (std::uint64_t{samples.front().index} << 32) | kLightVertexSeed));
}

std::optional<SelectedVertex> select_vertex(const LightVertexPool& pool,
                                            const LightSampleContext& at,
                                            std::uint32_t path,
                                            int bounce) {
  const std::uint64_t place =
      mix(pool.first, (std::uint64_t{path} << 32) | static_cast<std::uint32_t>(bounce));
  std::array<float, kCandidates> targets{};
  float sum = 0;
  for (std::size_t i = 0; i < kCandidates; ++i)
    sum += targets[i] = unblocked_contribution(candidate(pool, path, bounce, i), at);
  if (!(sum > 0)) return std::nullopt;
  float left = static_cast<float>(place >> 40) * 0x1p-24F * sum;
  std::size_t chosen = 0;
  // The last one with a target stands in where rounding leaves a rest.
  for (std::size_t i = 0; i < kCandidates && left >= 0; ++i) {
    if (!(targets[i] > 0)) continue;
    chosen = i;
    left -= targets[i];
  }
  return SelectedVertex{candidate(pool, path, bounce, chosen), sum / (kCandidates * targets[chosen])};
}

}  // namespace orbs::tracer

#pragma once

#include "tracer/integrator/trace_batch.h"
#include "tracer/irradiance_cache/record.h"
#include "tracer/transport/rgb_transport.h"
#include "tracer/world/nearest_hits.h"

#include <span>

/// The path tracer's batch with a visitor that looks at each vertex before it scatters. The loop of the path
/// tracer itself stays free of it.
namespace orbs::tracer {

/// Irradiance is kept in three channels; this transport has all materials that render in them.
using CacheTransport = RgbBoundaryTransport;
using CacheBatch = PathBatch<CacheTransport>;
using CacheVertices = VertexLanes<CacheTransport>;

template <typename Visitor>
void shade_visited(
    CacheBatch& batch, const World& world, std::span<const Sample> samples, int bounce, Visitor& visitor) {
  CacheVertices vertices;
  vertices.blocks.points = samples.front().block.points;  // the same for all
  for (std::size_t i = 0; i < batch.active.size(); ++i) {
    const std::uint32_t path = batch.active[i];
    const std::size_t lane = vertices.count;
    shade_hit<CacheTransport>(batch, world, vertices, path, samples[path], batch.hits[i]);
    visitor.after_hit(batch, path, batch.hits[i]);
    if (vertices.count > lane && !visitor.continues_at(batch, path, vertices, lane)) vertices.count = lane;
    const bool is_last = i + 1 == batch.active.size();
    if (vertices.count < kLanes && !(is_last && vertices.count > 0)) continue;
    scatter_vertices<CacheTransport>(batch, world, vertices, bounce);
    vertices.count = 0;
  }
}

/// Traces batch.active, whose paths all have scattered `bounce` times. visitor.after_hit(batch, path, hit)
/// comes after the emission of what a path hits was added; visitor.continues_at(batch, path, vertices, lane)
/// says whether the path samples light and scatters at the vertex.
template <typename Visitor>
void trace_visited(
    CacheBatch& batch, const World& world, std::span<const Sample> samples, int bounce, Visitor& visitor) {
  for (; !batch.active.empty(); ++bounce) {
    batch.rays.clear();
    for (const std::uint32_t path : batch.active) batch.rays.push_back(batch.paths[path].ray);
    batch.hits.resize(batch.rays.size());
    timed_traversal(batch, [&] { nearest_hits(world, batch.rays, batch.hits); });
    batch.survivors.clear();
    shade_visited(batch, world, samples, bounce, visitor);
    batch.active.swap(batch.survivors);
    resolve_mirror_rays(batch, world);
    resolve_shadow_rays(batch, world);
  }
}

inline bool is_delta_at(const CacheVertices& vertices, std::size_t lane) {
  return is_delta(vertices.bsdf[lane]);
}

/// The reflectance of a vertex that the cache can light, one whose BSDF is constant; else null.
inline const LambertBsdf<Vec3f>* cached_bsdf(const CacheVertices& vertices, std::size_t lane) {
  return std::get_if<LambertBsdf<Vec3f>>(&vertices.bsdf[lane]);
}

inline SurfaceElement element_at(const CacheVertices& vertices, std::size_t lane) {
  return {lane_of(vertices.position, lane), vertices.position_error[lane],
          lane_of(vertices.shading_normal, lane)};
}

}  // namespace orbs::tracer

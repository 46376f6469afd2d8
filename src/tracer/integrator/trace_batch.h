#pragma once

#include "spectra/wavelengths.h"
#include "tracer/integrator/connect_light_vertices.h"
#include "tracer/integrator/light_path_batch.h"
#include "tracer/integrator/sample_direct_light.h"
#include "tracer/integrator/sample_mirrored_light.h"
#include "tracer/integrator/scatter.h"
#include "tracer/integrator/shade_hit.h"
#include "tracer/integrator/timed_camera_ray.h"
#include "tracer/world/nearest_hits.h"

#include <span>

/// The path tracer: unidirectional, with next-event estimation and multiple importance sampling by the power
/// heuristic (Kajiya 1986; Veach 1997, ch. 9). Two techniques come on top: next-event estimation by way of a
/// flat mirror (sample_mirrored_light.h), and light tracing for caustics, which are skipped here
/// (is_left_to_light_paths; trace_light_batch.h). A batch of paths advances together, one scattering event at
/// a time, so that rays reach the accelerator in full packets and vertices fill the vector registers. The
/// result of a path does not depend on the other paths of its batch. Read from the bottom up: trace_batch,
/// shade_batch, and the steps in their headers.
namespace orbs::tracer {

template <Transport T>
void start_paths(PathBatch<T>& batch, const World& world, std::span<const Sample> samples) {
  batch.paths.resize(samples.size());
  batch.active.resize(samples.size());
  batch.classed.clear();
  for (std::uint32_t i = 0; i < samples.size(); ++i) {
    const Sample& sample = samples[i];
    const auto u = draw(sample.block, sample.index, 0, SampleDimension::PixelAndFirstLight);
    PathState<T>& path = batch.paths[i];
    path = {};
    path.sample = i;
    path.first_light_numbers = {u[2], u[3]};
    path.ray = timed_camera_ray(world, static_cast<float>(sample.x) + u[0],
                                static_cast<float>(sample.y) + u[1], sample.block, sample.index);
    path.throughput = world.moving_camera ? T::start(camera_at(world, path.ray.time), path.ray)
                                          : T::start(world.camera, path.ray);
    path.lambda = T::sample_lambda([&samples, i] {
      const auto point = draw(samples[i].block, samples[i].index, 0, SampleDimension::Wavelength);
      return spectra::wavelength_number(point[0], point[1]);
    });
    batch.active[i] = i;
  }
}

/// All paths of the vertices have scattered `bounce` times before.
template <Transport T>
void scatter_vertices(PathBatch<T>& batch, const World& world, const VertexLanes<T>& vertices, int bounce) {
  const auto frame = frame_around(vertices.shading_normal);
  const Vec8 wo = frame.to_local(vertices.to_viewer);
  sample_direct_light(batch, world, vertices, frame, wo, bounce);
  sample_mirrored_light(batch, world, vertices, frame, bounce);
  if constexpr (TracesFromLights<T>)
    if (world.connects_light_vertices) connect_light_vertices(batch, world, vertices, frame, wo, bounce);
  scatter(batch, world, vertices, frame, wo, bounce);
}

/// Shades the hits of all active paths and scatters those that continue, eight at a time.
template <Transport T>
void shade_batch(PathBatch<T>& batch, const World& world, std::span<const Sample> samples, int bounce) {
  VertexLanes<T> vertices;
  vertices.blocks.points = samples.front().block.points;  // the same for all
  for (std::size_t i = 0; i < batch.active.size(); ++i) {
    shade_hit<T>(batch, world, vertices, batch.active[i], samples[batch.active[i]], batch.hits[i]);
    const bool is_last = i + 1 == batch.active.size();
    if (vertices.count < kLanes && !(is_last && vertices.count > 0)) continue;
    scatter_vertices<T>(batch, world, vertices, bounce);
    vertices.count = 0;
  }
}

/// Traces one path per sample; batch.paths[i].radiance is the result of samples[i].
template <Transport T>
void trace_batch(PathBatch<T>& batch, const World& world, std::span<const Sample> samples) {
  start_paths(batch, world, samples);
  if (world.connects_light_vertices) {
    trace_light_vertices(batch.light_vertices, world, samples);
    batch.traversal_seconds += batch.light_vertices.traversal_seconds;
  }
  for (int bounce = 0; !batch.active.empty(); ++bounce) {
    batch.rays.clear();
    for (const std::uint32_t path : batch.active) batch.rays.push_back(batch.paths[path].ray);
    batch.hits.resize(batch.rays.size());
    const auto coherence = bounce == 0 ? Coherence::Neighbours : Coherence::None;
    timed_traversal(batch, [&] { nearest_hits(world, batch.rays, batch.hits, coherence); });
    batch.survivors.clear();
    shade_batch(batch, world, samples, bounce);
    batch.active.swap(batch.survivors);
    resolve_mirror_rays(batch, world);
    resolve_shadow_rays(batch, world);
  }
}

}  // namespace orbs::tracer

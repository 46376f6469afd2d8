#pragma once

#include "base/nth.h"
#include "tracer/geometry/transforms.h"
#include "tracer/integrator/path_batch.h"
#include "tracer/integrator/sample_direct_light.h"
#include "tracer/numeric_fault.h"
#include "tracer/world/surface.h"

#include <algorithm>
#include <array>
#include <cmath>

/// BSDF sampling: where the paths go next.
namespace orbs::tracer {

/// Russian roulette from the second scattering event on. The survival probability is the square root of the
/// throughput, from which the radiance scale of refraction is divided out, as refraction on the way out
/// undoes it. With the throughput as the probability so many paths end in rooms of medium albedo that noise
/// grows by more than the time saved: by 0.4 to 1 dB at equal time on scenes 101, 201 and 224.
template <Transport T>
bool survives_roulette(PathState<T>& path, const World& world, float u) {
  constexpr int kFaultyDepth = 32;
  if (has_fault(NumericFault::DepthLimited) && path.scatterings > kFaultyDepth) return false;
  if (!world.roulette) return T::magnitude(path.throughput) > 0;
  if (path.scatterings < 2) return true;
  // Mirrors alone make no noise, and roulette would make all there is: 27 standard deviations per sample in a
  // hall of two mirrors. So their paths go on until what they still carry is below a thousandth, of which
  // roulette makes noise that nobody sees.
  constexpr float kDeltasLeaveThroughput = 0x1p-10F;
  const float by_throughput = std::sqrt(T::magnitude(path.throughput) / path.radiance_scale /
                                        (path.has_deltas_alone ? kDeltasLeaveThroughput : 1));
  // A path between lossless mirrors never loses throughput. From a depth on that no limit of a scene file
  // reaches, some end anyway: of those that get to it kDeepest / n get to the n-th event. A horizon between
  // mirrors has light in proportion to 1 / n^2 there, so that its variance is finite (any geometric decay has
  // an infinite one, and is too dark in all that anyone renders), and a path that nothing ends takes 8000
  // events on average before kUnlimitedDepth.
  constexpr int kDeepest = 1000;
  const auto events = static_cast<float>(path.scatterings);
  const float probability =
      path.scatterings > kDeepest ? std::min(by_throughput, (events - 1) / events) : by_throughput;
  if (probability >= 1) return true;
  if (u >= probability) return false;
  if (!has_fault(NumericFault::RouletteWithoutWeight))
    path.throughput = T::scaled(path.throughput, 1 / probability);
  return true;
}

/// Records what MIS needs if the next ray hits an emitter.
template <Transport T>
void note_mis_state(
    PathState<T>& path, const World& world, const VertexLanes<T>& vertices, std::size_t lane, float pdf) {
  // The previous vertex could have sampled the same light by way of this mirror.
  const bool could_have_sampled = path.bsdf_pdf > 0 && !path.came_by_mirror;
  path.came_by_mirror = could_have_sampled && vertices.mirror_plane[lane] >= 0;
  if (path.came_by_mirror) {
    const MirrorPlane& plane = nth(world.mirror_planes, vertices.mirror_plane[lane]);
    const Vec3f vertex = path.light_sample.position;
    const int count = count_planes_facing(world.mirror_planes, vertex);
    path.mirror_probability = is_in_front(plane, vertex) ? 1 / static_cast<float>(count) : 0;
    path.light_sample = {mirrored(plane, vertex), {}};
    return;
  }
  path.bsdf_pdf = is_delta(vertices.bsdf[lane]) ? 0 : pdf;
  path.light_sample = light_sample_context(vertices, lane);
}

/// Records what the weights of MIS need if the next ray hits an emitter that a connection to this vertex
/// could have come from.
template <Transport T>
void note_connection(PathState<T>& path, Vec3f geometric_normal) {
  path.connection_pdf = 0;
  if (!(path.bsdf_pdf > 0) || path.came_by_mirror) return;
  path.connection_pdf =
      connection_pdf(1, std::abs(dot(geometric_normal, path.ray.direction)), path.arrival_pdf);
}

/// Samples the BSDF of each vertex and gives the paths their next rays; those that survive are appended to
/// batch.survivors.
template <Transport T>
void scatter(PathBatch<T>& batch,
             const World& world,
             const VertexLanes<T>& vertices,
             const FrameOf<Vec8>& frame,
             Vec8 wo,
             int bounce) {
  const auto u =
      draw(vertices.blocks, vertices.index, static_cast<std::uint32_t>(bounce), SampleDimension::Scatter);
  std::array<std::optional<BsdfSample<typename T::Value>>, kLanes> chosen;
  Vec8 wi{};
  for (std::size_t lane = 0; lane < vertices.count; ++lane) {
    chosen[lane] =
        sample(vertices.bsdf[lane], lane_of(wo, lane), {u[0][lane], u[1][lane], u[2][lane], u[3][lane]});
    if (chosen[lane]) set_lane(wi, lane, chosen[lane]->wi);
  }
  const Vec8 direction = frame.to_world(wi);
  const Mask8 agree = sides_agree(vertices.geometric_normal, frame.z, direction);
  const Vec8 origin =
      offset_origin(vertices.position, vertices.position_error, vertices.geometric_normal, direction);
  for (std::size_t lane = 0; lane < vertices.count; ++lane) {
    if (!chosen[lane] || agree[lane] == 0) continue;
    PathState<T>& path = batch.paths[vertices.path[lane]];
    path.throughput = T::chain(path.throughput, chosen[lane]->weight,
                               [&] { return scattering_at(vertices, frame, lane, wo, wi); });
    // In the tail of a near-specular lobe light paths connect the first surface to the camera after all. They
    // do not where the pdf is zero, as the BSDF has no value there.
    const float pdf = chosen[lane]->pdf;
    if (is_at_first_surface(path) && !is_delta(vertices.bsdf[lane]) && pdf > 0 && pdf < kTailPdf)
      path.is_reached_by_light_paths = true;
    path.radiance_scale *= chosen[lane]->radiance_scale;
    note_mis_state<T>(path, world, vertices, lane, chosen[lane]->pdf);
    path.has_deltas_alone = path.has_deltas_alone && is_delta(vertices.bsdf[lane]);
    path.events.append(event_of(vertices.bsdf[lane]), chosen[lane]->is_transmitted);
    path.ray.origin = lane_of(origin, lane);
    path.ray.nearest = 0;
    path.ray.direction = lane_of(direction, lane);
    if (world.connects_light_vertices) note_connection(path, lane_of(vertices.geometric_normal, lane));
    ++path.scatterings;
    // The fourth number is free: sample() uses three at most.
    if (survives_roulette<T>(path, world, u[3][lane])) batch.survivors.push_back(vertices.path[lane]);
  }
}

}  // namespace orbs::tracer

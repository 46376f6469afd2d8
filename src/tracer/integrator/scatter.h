#pragma once

#include "tracer/integrator/light_sampling.h"
#include "tracer/geometry/frame.h"
#include "tracer/integrator/make_boundary.h"
#include "tracer/sampling/warps.h"
#include "tracer/bsdf/scattering.h"
#include "tracer/integrator/path_batch.h"

#include <array>
#include <cmath>
#include <span>

/// Eight paths scatter together: their geometry in vector registers, what they carry one by one.
namespace orbs::tracer {

template <Transport T>
struct VertexLanes {
  Vec8 position{};
  Vec8 geometric_normal{};
  Vec8 shading_normal{};  // turned to the viewer
  Vec8 to_viewer{};
  Float8 position_error{};
  Word8 block{};  // of the samples
  Word8 index{};
  std::array<std::uint32_t, kLanes> path{};
  std::array<typename T::Bsdf, kLanes> bsdf;
  std::array<bool, kLanes> wants_light{};
  std::array<int, kLanes> mirror_plane{};  // of the surface, or -1
  std::array<int, kLanes> own_light{};     // the light that it is the surface of, or -1
  std::size_t count = 0;  // lanes in use; the others compute with what they held before, for nobody
};

template <Transport T>
Scattering<typename T::Bsdf> scattering_at(const VertexLanes<T>& vertices,
                                           const FrameOf<Vec8>& frame,
                                           std::size_t lane,
                                           const Vec8& wo,
                                           const Vec8& wi) {
  return {vertices.bsdf[lane],
          {lane_of(frame.x, lane), lane_of(frame.y, lane), lane_of(frame.z, lane)},
          lane_of(vertices.to_viewer, lane),
          lane_of(wo, lane),
          lane_of(wi, lane)};
}

/// Light that comes out of a sharp surface and reaches the camera from another that is not, or by the tail of
/// its lobe, by itself or by a flat mirror: light paths bring it (see World::caustic_casters).
template <Transport T>
bool is_left_to_light_paths(const World& world, const PathState<T>& path) {
  return path.near_specular_beyond_first && path.is_reached_by_light_paths && !world.caustic_casters.empty();
}

/// Numbers for choosing a light and a point on it. The first point shares its set with the pixel position:
/// stratifying the four together is what keeps the fast convergence of direct light.
template <Transport T>
std::array<Float8, 3> light_numbers(const PathBatch<T>& batch,
                                    const World& world,
                                    const VertexLanes<T>& vertices,
                                    int bounce) {
  if (bounce > 0) {
    const auto u = draw(vertices.block, vertices.index, static_cast<std::uint32_t>(bounce), SampleDimension::Light);
    return {u[0], u[1], u[2]};
  }
  std::array<Float8, 3> out{};
  if (world.emitters.size() > 1) out[0] = draw(vertices.block, vertices.index, 0, SampleDimension::LightPick)[0];
  for (std::size_t lane = 0; lane < vertices.count; ++lane) {
    const Vec2f first = batch.paths[vertices.path[lane]].first_light_sample;
    out[1][lane] = first.x;
    out[2][lane] = first.y;
  }
  return out;
}

/// Light samples of eight vertices; pdf = 0 where there is none.
struct LightLanes {
  Vec8 position{};
  std::array<Vec3f, kLanes> target{};
  Float8 pdf{};
  std::array<Radiance, kLanes> radiance;
};

template <Transport T>
LightLanes sample_lights(const PathBatch<T>& batch,
                         const World& world,
                         const VertexLanes<T>& vertices,
                         int bounce) {
  LightLanes out;
  const auto numbers = light_numbers(batch, world, vertices, bounce);
  for (std::size_t lane = 0; lane < vertices.count; ++lane) {
    if (!vertices.wants_light[lane]) continue;
    const auto light = sample_light(world, lane_of(vertices.position, lane), numbers[0][lane],
                                    numbers[1][lane], numbers[2][lane]);
    // Lights are flat or convex: none lights itself, but rounding may place a point of it before it.
    if (!light || static_cast<int>(light->emitter) == vertices.own_light[lane]) continue;
    set_lane(out.position, lane, light->position);
    out.target[lane] = light->target;
    out.pdf[lane] = light->pdf;
    out.radiance[lane] = light->radiance;
  }
  return out;
}

template <Transport T>
void sample_direct_light(PathBatch<T>& batch,
                          const World& world,
                          const VertexLanes<T>& vertices,
                          const FrameOf<Vec8>& frame,
                          Vec8 wo,
                          int bounce) {
  const LightLanes light = sample_lights(batch, world, vertices, bounce);
  const Vec8 direction = normalised(light.position - vertices.position);
  const Vec8 wi = frame.to_local(direction);
  std::array<typename T::Value, kLanes> f_cos;
  Float8 pdf{};
  for (std::size_t lane = 0; lane < vertices.count; ++lane) {
    if (!(light.pdf[lane] > 0)) continue;
    const auto value = evaluate(vertices.bsdf[lane], lane_of(wo, lane), lane_of(wi, lane));
    f_cos[lane] = value.f_cos;
    pdf[lane] = value.pdf;
  }
  const Float8 share = mis_weight(light.pdf, pdf) / light.pdf;
  const Mask8 agree = sides_agree(vertices.geometric_normal, frame.z, direction);
  const Vec8 origin =
      offset_origin(vertices.position, vertices.position_error, vertices.geometric_normal, direction);
  for (std::size_t lane = 0; lane < vertices.count; ++lane) {
    if (!(pdf[lane] > 0) || agree[lane] == 0) continue;
    const PathState<T>& path = batch.paths[vertices.path[lane]];
    PathClass events = path.events;
    events.add(event_of(vertices.bsdf[lane]), wi.z[lane] < 0);
    const auto emitted = T::radiance(world, light.radiance[lane], path.lambda) * share[lane];
    const auto through =
        T::chain(path.throughput, f_cos[lane], [&] { return scattering_at(vertices, frame, lane, wo, wi); });
    const Vec3f from = lane_of(origin, lane);
    batch.shadow_rays.push_back({from, light.target[lane] - from, 1});
    batch.shadows.push_back({T::contribute(through, emitted), vertices.path[lane], events.index()});
  }
}

/// From the second scattering on, the path continues with a chance of the square root of its weight, and
/// carries the share of those that do not. The weight itself as the chance ends so many paths in rooms of
/// medium albedo that the noise grows by more than the time saved: by 0.4 to 1 dB at equal time on scenes
/// 101, 201 and 224.
template <Transport T>
bool survives_roulette(PathState<T>& path, float u) {
  if (path.scatterings < 2) return true;
  const float probability = std::sqrt(T::magnitude(path.throughput) / path.radiance_scale);
  if (probability >= 1) return true;
  if (u >= probability) return false;
  path.throughput = T::scaled(path.throughput, 1 / probability);
  return true;
}

/// What multiple importance sampling needs to know when the next ray meets a light.
template <Transport T>
void note_mis_state(
    PathState<T>& path, const World& world, const VertexLanes<T>& vertices, std::size_t lane, float pdf) {
  const bool could_have_sampled =
      path.bsdf_pdf > 0 && !path.came_by_mirror;  // the point before, by this mirror
  path.came_by_mirror = could_have_sampled && vertices.mirror_plane[lane] >= 0;
  if (path.came_by_mirror) {
    const MirrorPlane& plane = world.mirror_planes[static_cast<std::size_t>(vertices.mirror_plane[lane])];
    const int count = planes_before(world.mirror_planes, path.ray.origin);
    path.mirror_probability = is_before(plane, path.ray.origin) ? 1 / static_cast<float>(count) : 0;
    path.mirrored_vertex = mirrored(plane, path.ray.origin);
    return;
  }
  path.bsdf_pdf = is_delta(vertices.bsdf[lane]) ? 0 : pdf;
}

/// Gives the paths their next rays; those that go on are appended to batch.survivors.
template <Transport T>
void scatter(PathBatch<T>& batch,
             const World& world,
             const VertexLanes<T>& vertices,
             const FrameOf<Vec8>& frame,
             Vec8 wo,
             int bounce) {
  const auto u = draw(vertices.block, vertices.index, static_cast<std::uint32_t>(bounce), SampleDimension::Scatter);
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
    if (is_at_first_surface(path) && !is_delta(vertices.bsdf[lane]) && chosen[lane]->pdf < kTailPdf)
      path.is_reached_by_light_paths = true;
    path.radiance_scale *= chosen[lane]->radiance_scale;
    note_mis_state<T>(path, world, vertices, lane, chosen[lane]->pdf);
    path.events.add(event_of(vertices.bsdf[lane]), chosen[lane]->is_transmitted);
    path.ray.origin = lane_of(origin, lane);
    path.ray.direction = lane_of(direction, lane);
    ++path.scatterings;
    if (survives_roulette<T>(path, u[3][lane])) batch.survivors.push_back(vertices.path[lane]);
  }
}

}  // namespace orbs::tracer

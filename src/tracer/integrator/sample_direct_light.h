#pragma once

#include "tracer/bsdf/bsdf_sample.h"
#include "tracer/geometry/transforms.h"
#include "tracer/integrator/light_sampling.h"
#include "tracer/integrator/path_batch.h"
#include "tracer/light/direct_light.h"

#include <array>

/// Next-event estimation: light sampling at up to eight vertices at once.
namespace orbs::tracer {

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

/// Surfaces that are not diffuse may transmit, so light may reach them from behind.
template <Transport T>
LightSampleContext light_sample_context(const VertexLanes<T>& vertices, std::size_t lane) {
  const bool is_diffuse = event_of(vertices.bsdf[lane]) == Event::Diffuse;
  return {lane_of(vertices.position, lane), is_diffuse ? lane_of(vertices.shading_normal, lane) : Vec3f{}};
}

/// Random numbers for the choice of an emitter, of a point on it, and the digits of the first that no float
/// holds. At the first bounce the point takes the two numbers that the pixel position leaves of its set of
/// four, so that pixel and light are stratified jointly.
template <Transport T>
std::array<Float8, 4> light_numbers(const PathBatch<T>& batch,
                                    const World& world,
                                    const VertexLanes<T>& vertices,
                                    int bounce) {
  if (bounce > 0) {
    const auto u =
        draw(vertices.blocks, vertices.index, static_cast<std::uint32_t>(bounce), SampleDimension::Light);
    return {u[0], u[1], u[2], u[3]};
  }
  std::array<Float8, 4> out{};
  if (world.emitters.size() > 1) {
    const auto u = draw(vertices.blocks, vertices.index, 0, SampleDimension::LightPick);
    out[0] = u[0];
    out[3] = u[1];
  }
  for (std::size_t lane = 0; lane < vertices.count; ++lane) {
    const Vec2f first = batch.paths[vertices.path[lane]].first_light_numbers;
    out[1][lane] = first.x;
    out[2][lane] = first.y;
  }
  return out;
}

/// Light samples of eight vertices; pdf = 0 if there is none.
struct LightLanes {
  Vec8 position{};
  std::array<Vec3f, kLanes> target{};
  Float8 pdf{};
  Float8 emission_pdf{};  // as in LightSample
  std::array<Radiance, kLanes> radiance;
  std::array<bool, kLanes> can_be_hit{};  // as in LightSample
};

template <Transport T>
LightLanes sample_lights(const PathBatch<T>& batch,
                         const World& world,
                         const VertexLanes<T>& vertices,
                         int bounce) {
  LightLanes out;
  const auto numbers = light_numbers(batch, world, vertices, bounce);
  for (std::size_t lane = 0; lane < vertices.count; ++lane) {
    if (!vertices.samples_light[lane]) continue;
    const auto light = sample_light(world, light_sample_context(vertices, lane),
                                    with_more_digits(numbers[0][lane], numbers[3][lane]), numbers[1][lane],
                                    numbers[2][lane]);
    // Lights are flat or convex, so none illuminates itself. But rounding can make it seem so.
    if (!light || static_cast<int>(light->emitter) == vertices.own_light[lane]) continue;
    set_lane(out.position, lane, light->position);
    out.target[lane] = light->target;
    out.pdf[lane] = light->pdf;
    out.emission_pdf[lane] = light->emission_pdf;
    out.radiance[lane] = light->radiance;
    out.can_be_hit[lane] = light->can_be_hit;
  }
  return out;
}

/// Appends a shadow ray for each vertex that samples light.
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
  Float8 bsdf_pdf{};
  Float8 hit_pdf{};  // with which BSDF sampling would find the light
  Float8 connected_pdf{};
  for (std::size_t lane = 0; lane < vertices.count; ++lane) {
    if (!(light.pdf[lane] > 0)) continue;
    const auto value = evaluate(vertices.bsdf[lane], lane_of(wo, lane), lane_of(wi, lane));
    f_cos[lane] = value.f_cos;
    bsdf_pdf[lane] = value.pdf;
    hit_pdf[lane] = light.can_be_hit[lane] ? value.pdf : 0;
    if (!world.connects_light_vertices) continue;
    const float cosine = std::abs(dot(lane_of(vertices.geometric_normal, lane), lane_of(direction, lane)));
    connected_pdf[lane] =
        connection_pdf(light.emission_pdf[lane], cosine, batch.paths[vertices.path[lane]].arrival_pdf);
  }
  const Float8 weight = light_weight(world.direct_light, light.pdf, hit_pdf, connected_pdf) / light.pdf;
  const Mask8 agree = sides_agree(vertices.geometric_normal, frame.z, direction);
  const Vec8 origin =
      offset_origin(vertices.position, vertices.position_error, vertices.geometric_normal, direction);
  for (std::size_t lane = 0; lane < vertices.count; ++lane) {
    if (!(bsdf_pdf[lane] > 0) || agree[lane] == 0) continue;
    const PathState<T>& path = batch.paths[vertices.path[lane]];
    PathClass events = path.events;
    events.append(event_of(vertices.bsdf[lane]), wi.z[lane] < 0);
    const auto emitted = T::radiance(world, light.radiance[lane], path.lambda) * weight[lane];
    const auto throughput =
        T::chain(path.throughput, f_cos[lane], [&] { return scattering_at(vertices, frame, lane, wo, wi); });
    const Vec3f from = lane_of(origin, lane);
    batch.shadow_rays.push_back({from, light.target[lane] - from, 1, 0, path.ray.time});
    batch.shadow_payloads.push_back(
        {T::contribute(throughput, emitted), vertices.path[lane], events.index()});
  }
}

/// Adds the contributions whose shadow rays are not blocked.
template <Transport T>
void resolve_shadow_rays(PathBatch<T>& batch, const World& world) {
  batch.blocked.resize(batch.shadow_rays.size());
  timed_traversal(batch, [&] { world.accel->occluded(batch.shadow_rays, batch.blocked); });
  for (std::size_t i = 0; i < batch.shadow_payloads.size(); ++i) {
    const ShadowPayload<T>& shadow = batch.shadow_payloads[i];
    if (batch.blocked[i] == 0)
      add_contribution(batch, batch.paths[shadow.path], shadow.light, shadow.path_class);
  }
  batch.shadow_rays.clear();
  batch.shadow_payloads.clear();
}

}  // namespace orbs::tracer

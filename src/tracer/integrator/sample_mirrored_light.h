#pragma once

#include "base/nth.h"
#include "tracer/bsdf/bsdf_sample.h"
#include "tracer/geometry/transforms.h"
#include "tracer/integrator/light_sampling.h"
#include "tracer/integrator/path_batch.h"
#include "tracer/light/direct_light.h"
#include "tracer/world/nearest_hits.h"

#include <algorithm>
#include <array>
#include <optional>

/// Next-event estimation by way of one flat mirror: from a vertex, a light in the mirror is seen as the light
/// itself from the mirrored vertex.
namespace orbs::tracer {

/// Appends a ray towards the mirror if the vertex of this lane samples light there.
template <Transport T>
void sample_mirrored_light(PathBatch<T>& batch,
                           const World& world,
                           const VertexLanes<T>& vertices,
                           std::size_t lane,
                           const FrameOf<Vec3f>& frame,
                           const std::array<float, 4>& u) {
  const PathState<T>& path = batch.paths[vertices.path[lane]];
  const Vec3f position = lane_of(vertices.position, lane);
  const int count = count_planes_facing(world.mirror_planes, position);
  if (count == 0) return;
  const float place = u[3] * static_cast<float>(count);
  const int n = std::min(count - 1, static_cast<int>(place));
  const int chosen = plane_facing(world.mirror_planes, position, n);
  const MirrorPlane& plane = nth(world.mirror_planes, chosen);
  const Vec3f mirrored_position = mirrored(plane, position);
  const auto light = sample_light(world, {mirrored_position, {}},
                                  with_more_digits(u[0], place - static_cast<float>(n)), u[1], u[2]);
  if (!light || !(height_over(plane, light->position) > 0)) return;
  const Vec3f direction = mirrored_direction(plane, normalised(light->position - mirrored_position));
  const Vec3f wo = frame.to_local(lane_of(vertices.to_viewer, lane));
  const Vec3f wi = frame.to_local(direction);
  const auto value = evaluate(vertices.bsdf[lane], wo, wi);
  const Vec3f geometric_normal = lane_of(vertices.geometric_normal, lane);
  if (!(value.pdf > 0) || !sides_agree(geometric_normal, frame.z, direction)) return;
  const float pdf = light->pdf / static_cast<float>(count);
  PathClass events = path.events;
  events.append(event_of(vertices.bsdf[lane]), dot(frame.z, direction) < 0);
  events.append(Event::Specular, false);
  const float hit_pdf = light->can_be_hit ? value.pdf : 0;
  const float weight = light_weight(world.direct_light, pdf, hit_pdf, 0.0F) / pdf;
  const auto emitted = T::radiance(world, light->radiance, path.lambda) * weight;
  batch.mirror_rays.push_back(
      {.origin = offset_origin(position, vertices.position_error[lane], geometric_normal, direction),
       .direction = direction,
       .time = path.ray.time});
  const auto throughput = T::chain(path.throughput, value.f_cos, [&] {
    return Scattering<typename T::Bsdf>{vertices.bsdf[lane], frame, lane_of(vertices.to_viewer, lane), wo,
                                        wi};
  });
  batch.mirror_payloads.push_back(
      {throughput, emitted, light->target, chosen, vertices.path[lane], events.index()});
}

template <Transport T>
void sample_mirrored_light(PathBatch<T>& batch,
                           const World& world,
                           const VertexLanes<T>& vertices,
                           const FrameOf<Vec8>& frame,
                           int bounce) {
  if (world.mirror_planes.empty() || bounce + 2 > world.trace_depth) return;  // this event and the mirror
  const auto u = draw(vertices.blocks, vertices.index, static_cast<std::uint32_t>(bounce),
                      SampleDimension::MirroredLight);
  for (std::size_t lane = 0; lane < vertices.count; ++lane) {
    if (is_delta(vertices.bsdf[lane])) continue;
    const FrameOf<Vec3f> lane_frame{lane_of(frame.x, lane), lane_of(frame.y, lane), lane_of(frame.z, lane)};
    sample_mirrored_light(batch, world, vertices, lane, lane_frame,
                          {u[0][lane], u[1][lane], u[2][lane], u[3][lane]});
  }
}

/// A hit on a flat mirror.
template <Transport T>
struct MirrorHit {
  SurfacePoint point;
  typename T::Value reflectance{};
};

/// Nothing if the ray hits no triangle of this mirror plane.
template <Transport T>
std::optional<MirrorHit<T>> mirror_hit(
    const World& world, const Ray& ray, const Hit& hit, int plane, const typename T::Lambda& lambda) {
  if (hit.object == kNoHit || mirror_plane_of(world, hit.object, hit.primitive) != plane) return std::nullopt;
  const SurfacePoint point = surface_point(world, ray, hit);
  const auto& mirror = std::get<MirrorMaterial>(nth(world.materials, point.material).model);
  return MirrorHit<T>{point, T::reflectance(world, mirror.reflectance, lambda)};
}

/// Light samples whose ray hits the mirror continue from there as shadow rays.
template <Transport T>
void resolve_mirror_rays(PathBatch<T>& batch, const World& world) {
  batch.mirror_hits.resize(batch.mirror_rays.size());
  timed_traversal(batch, [&] { nearest_hits(world, batch.mirror_rays, batch.mirror_hits); });
  for (std::size_t i = 0; i < batch.mirror_payloads.size(); ++i) {
    const MirrorPayload<T>& payload = batch.mirror_payloads[i];
    const Ray& ray = batch.mirror_rays[i];
    const auto found =
        mirror_hit<T>(world, ray, batch.mirror_hits[i], payload.plane, batch.paths[payload.path].lambda);
    if (!found) continue;
    const typename T::Bsdf bsdf = MirrorBsdf<typename T::Value>{found->reflectance};
    const auto throughput = T::chain(payload.throughput, found->reflectance, [&] {
      const Frame frame = frame_around(nth(world.mirror_planes, payload.plane).normal);
      const Vec3f wo = frame.to_local(-ray.direction);
      return Scattering<typename T::Bsdf>{bsdf, frame, -ray.direction, wo, {-wo.x, -wo.y, wo.z}};
    });
    const SurfacePoint& point = found->point;
    const Vec3f origin = offset_origin(point.position, point.position_error, point.geometric_normal,
                                       payload.target - point.position);
    batch.shadow_rays.push_back({origin, payload.target - origin, 1, 0, ray.time});
    batch.shadow_payloads.push_back(
        {T::contribute(throughput, payload.emitted), payload.path, payload.path_class});
  }
  batch.mirror_rays.clear();
  batch.mirror_payloads.clear();
}

}  // namespace orbs::tracer

#pragma once

#include "tracer/integrator/scatter.h"

#include <algorithm>

/// Next-event estimation by way of one flat mirror: seen from a point, a lamp in the mirror is the lamp seen
/// from the point's image behind the mirror.
namespace orbs::tracer {

/// The path that one lane's vertex asks for light by way of the mirror.
template <Transport T>
void sample_mirrored_light(PathBatch<T>& batch,
                            const World& world,
                            const VertexLanes<T>& vertices,
                            std::size_t lane,
                            const FrameOf<Vec3f>& frame,
                            const std::array<float, 4>& u) {
  const PathState<T>& path = batch.paths[vertices.path[lane]];
  const Vec3f position = lane_of(vertices.position, lane);
  const int count = planes_before(world.mirror_planes, position);
  if (count == 0) return;
  const int chosen = plane_before(world.mirror_planes, position,
                                  std::min(count - 1, static_cast<int>(u[3] * static_cast<float>(count))));
  const MirrorPlane& plane = world.mirror_planes[static_cast<std::size_t>(chosen)];
  const Vec3f image = mirrored(plane, position);
  const auto light = sample_light(world, image, u[0], u[1], u[2]);
  if (!light || !(height_over(plane, light->position) > 0)) return;
  const Vec3f from_image = normalised(light->position - image);
  const Vec3f direction = mirrored_direction(plane, from_image);
  const Vec3f wo = frame.to_local(lane_of(vertices.to_viewer, lane));
  const auto value = evaluate(vertices.bsdf[lane], wo, frame.to_local(direction));
  const Vec3f geometric_normal = lane_of(vertices.geometric_normal, lane);
  if (!(value.pdf > 0) || !sides_agree(geometric_normal, frame.z, direction)) return;
  const float pdf = light->pdf / static_cast<float>(count);
  PathClass events = path.events;
  events.add(event_of(vertices.bsdf[lane]), dot(frame.z, direction) < 0);
  events.add(Event::Specular, false);
  const auto emitted = T::radiance(world, light->radiance, path.lambda) * (mis_weight(pdf, value.pdf) / pdf);
  batch.mirror_rays.push_back(
      {offset_origin(position, vertices.position_error[lane], geometric_normal, direction), direction});
  const auto through = T::chain(path.throughput, value.f_cos, [&] {
    return Scattering<typename T::Bsdf>{vertices.bsdf[lane], frame, lane_of(vertices.to_viewer, lane), wo,
                                        frame.to_local(direction)};
  });
  batch.mirror_ray_payloads.push_back(
      {through, emitted, light->target, chosen, vertices.path[lane], events.index()});
}

template <Transport T>
void sample_mirrored_light(PathBatch<T>& batch,
                            const World& world,
                            const VertexLanes<T>& vertices,
                            const FrameOf<Vec8>& frame,
                            int bounce) {
  if (world.mirror_planes.empty() || bounce + 2 > world.trace_depth) return;
  const auto u =
      draw(vertices.block, vertices.index, static_cast<std::uint32_t>(bounce), SampleDimension::MirroredLight);
  for (std::size_t lane = 0; lane < vertices.count; ++lane) {
    if (is_delta(vertices.bsdf[lane])) continue;
    const FrameOf<Vec3f> own{lane_of(frame.x, lane), lane_of(frame.y, lane), lane_of(frame.z, lane)};
    sample_mirrored_light(batch, world, vertices, lane, own,
                           {u[0][lane], u[1][lane], u[2][lane], u[3][lane]});
  }
}

/// What a ray meets in a flat mirror.
template <Transport T>
struct AtMirror {
  SurfacePoint point;
  typename T::Bsdf bsdf;
  typename T::Value reflectance{};
};

/// Nothing when the hit is not in that mirror's plane.
template <Transport T>
std::optional<AtMirror<T>> reflection_at(
    const World& world, const Ray& ray, const Hit& hit, int plane, const typename T::Lambda& lambda) {
  if (hit.object == kNoHit || mirror_plane_of(world, hit.object, hit.primitive) != plane) return std::nullopt;
  AtMirror<T> out;
  out.point = surface_point(world, ray, hit);
  const SurfaceMaterial& material = world.materials[static_cast<std::size_t>(out.point.material)];
  make_orbs_bsdf<T>(out.bsdf, world, {out.point, material, hit}, true, lambda);
  out.reflectance = std::get<MirrorBsdf<typename T::Value>>(out.bsdf).reflectance;
  return out;
}

/// The queries whose ray meets the mirror go on from there as shadow rays.
template <Transport T>
void resolve_mirror_rays(PathBatch<T>& batch, const World& world) {
  batch.mirror_hits.resize(batch.mirror_rays.size());
  timed_traversal(batch, [&] { world.accel->intersect(batch.mirror_rays, batch.mirror_hits); });
  for (std::size_t i = 0; i < batch.mirror_ray_payloads.size(); ++i) {
    const MirrorRay<T>& query = batch.mirror_ray_payloads[i];
    const Ray& ray = batch.mirror_rays[i];
    const auto at_mirror =
        reflection_at<T>(world, ray, batch.mirror_hits[i], query.plane, batch.paths[query.path].lambda);
    if (!at_mirror) continue;
    const auto through = T::chain(query.throughput, at_mirror->reflectance, [&] {
      const Frame frame = frame_around(world.mirror_planes[static_cast<std::size_t>(query.plane)].normal);
      const Vec3f wo = frame.to_local(-ray.direction);
      return Scattering<typename T::Bsdf>{at_mirror->bsdf, frame, -ray.direction, wo, {-wo.x, -wo.y, wo.z}};
    });
    const SurfacePoint& point = at_mirror->point;
    const Vec3f origin = offset_origin(point.position, point.position_error, point.geometric_normal,
                                       query.target - point.position);
    batch.shadow_rays.push_back({origin, query.target - origin, 1});
    batch.shadows.push_back({T::contribute(through, query.emitted), query.path, query.path_class});
  }
  batch.mirror_rays.clear();
  batch.mirror_ray_payloads.clear();
}

}  // namespace orbs::tracer

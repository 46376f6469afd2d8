#pragma once

#include "tracer/geometry/transforms.h"
#include "tracer/integrator/light_path_batch.h"
#include "tracer/integrator/make_bsdf.h"
#include "tracer/integrator/path_batch.h"
#include "tracer/integrator/sample_mirrored_light.h"
#include "tracer/world/nearest_hits.h"

#include <cmath>
#include <optional>

/// Connections of light paths to the camera, which sees the surface directly or in a flat mirror.
namespace orbs::tracer {

// Cosine of a direction at the geometric normal. BSDFs give f times the cosine at the shading normal, but the
// flux of a light path is measured on the true surface. So light paths need the ratio of the two (the adjoint
// BSDF for shading normals; Veach 1997, 5.3).
inline float surface_cosine(const SurfacePoint& point, Vec3f direction) {
  return std::abs(dot(point.geometric_normal, direction));
}

/// Scattering of a light path towards the camera.
template <TracesFromLights T>
struct CameraConnection {
  typename T::Value throughput{};  // with this scattering event
  PathClass events;
  Vec3f origin;  // of the ray to the camera
};

/// At a hit of the light path, in the unit direction `to_camera`; `importance` as in CameraProjection.
/// Nothing if the surface scatters no light there, or if camera paths carry it.
template <TracesFromLights T>
std::optional<CameraConnection<T>> scattered_to_camera(const World& world,
                                                       const LightPath<T>& path,
                                                       const SurfaceHit& surface,
                                                       Vec3f to_camera,
                                                       float importance,
                                                       SampleBlock block) {
  const SurfacePoint& point = surface.point;
  const Vec3f to_light = -path.ray.direction;
  const float side = dot(point.shading_normal, to_camera);
  if (!sides_agree(point.geometric_normal, point.shading_normal, to_camera) ||
      !sides_agree(point.geometric_normal, point.shading_normal, to_light))
    return std::nullopt;
  const Frame frame = frame_around(side > 0 ? point.shading_normal : -point.shading_normal);
  const Vec3f wo = frame.to_local(to_camera);
  const Vec3f wi = frame.to_local(to_light);
  if (!(wo.z > 0)) return std::nullopt;  // by rounding at grazing angles
  CameraConnection<T> out;
  out.throughput = path.throughput;
  auto lambda = path.lambda;  // dispersion may end wavelengths for this connection, and not for the path
  typename T::Bsdf bsdf;
  make_bsdf<T>(bsdf, {world, surface, side > 0, lambda, out.throughput, block, path.index,
                      static_cast<std::uint32_t>(path.scatterings)});
  const auto value = evaluate(bsdf, wo, wi);
  if (!(value.pdf > 0) || (surface.material.is_near_specular && !(value.pdf < kTailPdf))) return std::nullopt;
  out.events = path.events;
  out.events.prepend(event_of(bsdf), wi.z < 0);
  const float factor = importance * surface_cosine(point, to_camera) / surface_cosine(point, to_light);
  out.throughput = out.throughput * (value.f_cos * factor);
  out.origin = offset_origin(point.position, point.position_error, point.geometric_normal, to_camera);
  return out;
}

/// Appends a ray from the hit of the light path to the camera, with the splat that it adds if not blocked.
/// `camera` is that of the world, of a lens the one at the path's point of it.
template <TracesFromLights T>
void connect_to_camera(LightPathBatch<T>& batch,
                       const World& world,
                       const Camera& camera,
                       const LightPath<T>& path,
                       SampleBlock block,
                       const SurfaceHit& surface) {
  const CameraProjection projection = project(camera, surface.point.position);
  if (!(projection.importance > 0)) return;
  const Vec3f to_camera = normalised(projection.viewpoint - surface.point.position);
  const auto found = scattered_to_camera(world, path, surface, to_camera, projection.importance, block);
  if (!found) return;
  batch.camera_rays.push_back({found->origin, projection.viewpoint - found->origin, 1});
  batch.camera_payloads.push_back(
      {projection.pixel, found->events.index(), T::to_rgb(found->throughput * path.emitted, path.lambda)});
}

/// Where the ray of the camera begins that sees a point in the mirror, as the mirrored camera does from
/// behind it: the camera's own position but where its rays are parallel.
inline Vec3f viewpoint_before(const MirrorPlane& plane,
                              const Camera& camera,
                              const CameraProjection& projection) {
  return std::holds_alternative<Orthographic>(camera.kind) ? mirrored(plane, projection.viewpoint)
                                                           : camera.position;
}

/// The same by way of every flat mirror that has both the surface and the camera in front of it.
template <TracesFromLights T>
void connect_to_camera_by_mirrors(LightPathBatch<T>& batch,
                                  const World& world,
                                  const Camera& camera,
                                  std::uint32_t index,
                                  SampleBlock block,
                                  const SurfaceHit& surface) {
  const LightPath<T>& path = batch.paths[index];
  if (path.scatterings + 2 > world.trace_depth) return;  // this event and the mirror
  for (std::size_t i = 0; i < world.mirror_planes.size(); ++i) {
    const MirrorPlane& plane = world.mirror_planes[i];
    if (!(height_over(plane, surface.point.position) > 0)) continue;
    const CameraProjection projection = project(mirrored(plane, camera), surface.point.position);
    if (!(projection.importance > 0)) continue;
    // The camera is tested as in note_near_specular, so that exactly one of camera and light paths adds each
    // contribution. The point needs no tolerance: what camera paths see of it in the mirror, they leave to
    // light paths at every height over the plane.
    const Vec3f viewpoint = viewpoint_before(plane, camera, projection);
    if (!is_in_front(plane, viewpoint)) continue;
    const Vec3f to_camera = normalised(projection.viewpoint - surface.point.position);
    auto found = scattered_to_camera(world, path, surface, to_camera, projection.importance, block);
    if (!found) continue;
    found->events.prepend(Event::Specular, false);
    batch.mirror_rays.push_back({found->origin, to_camera});
    batch.mirror_payloads.push_back(
        {found->throughput, viewpoint, index, projection.pixel, static_cast<int>(i), found->events.index()});
  }
}

/// Connections whose ray hits the mirror continue from there to the camera.
template <TracesFromLights T>
void resolve_mirror_rays(LightPathBatch<T>& batch, const World& world) {
  batch.mirror_hits.resize(batch.mirror_rays.size());
  timed_traversal(batch, [&] { nearest_hits(world, batch.mirror_rays, batch.mirror_hits); });
  for (std::size_t i = 0; i < batch.mirror_payloads.size(); ++i) {
    const CameraMirrorPayload<T>& payload = batch.mirror_payloads[i];
    const LightPath<T>& path = batch.paths[payload.path];
    const auto found =
        mirror_hit<T>(world, batch.mirror_rays[i], batch.mirror_hits[i], payload.plane, path.lambda);
    if (!found) continue;
    const Vec3f to_camera = payload.viewpoint - found->point.position;
    const Vec3f origin = offset_origin(found->point.position, found->point.position_error,
                                       found->point.geometric_normal, to_camera);
    const auto throughput = found->reflectance * payload.throughput;
    batch.camera_rays.push_back({origin, payload.viewpoint - origin, 1});
    batch.camera_payloads.push_back(
        {payload.pixel, payload.path_class, T::to_rgb(throughput * path.emitted, path.lambda)});
  }
  batch.mirror_rays.clear();
  batch.mirror_payloads.clear();
}

/// Adds the splats whose rays to the camera are not blocked.
template <TracesFromLights T>
void resolve_shadow_rays(LightPathBatch<T>& batch, const World& world) {
  batch.blocked.resize(batch.camera_rays.size());
  timed_traversal(batch, [&] { world.accel->occluded(batch.camera_rays, batch.blocked); });
  for (std::size_t i = 0; i < batch.camera_payloads.size(); ++i)
    if (batch.blocked[i] == 0) batch.splats.push_back(batch.camera_payloads[i]);
  batch.camera_rays.clear();
  batch.camera_payloads.clear();
}

}  // namespace orbs::tracer

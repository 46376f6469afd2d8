#pragma once

#include "tracer/integrator/light_emission.h"
#include "tracer/integrator/mirrored_light.h"

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <optional>
#include <vector>

/// What light paths leave at a surface towards the camera, which sees the surface itself or its image in a
/// flat mirror.
namespace orbs::tracer {

/// What a light path adds to a pixel: the mean over all light paths is the pixel's radiance.
struct Splat {
  std::uint32_t pixel = 0;
  int path_class = 0;
  Vec3f value;
};

/// Light paths carry plain factors: matrices would have to be multiplied from the other side.
template <typename T>
concept TracesFromLights = Transport<T> && std::same_as<typename T::Throughput, typename T::Value>;

template <TracesFromLights T>
struct LightPath {
  typename T::Value throughput{};   // of all scatterings
  typename T::Value emitted{};  // what left the light, over the density of the path's start
  [[no_unique_address]] typename T::Lambda lambda{};
  EmittedRay start;
  Ray ray;
  std::uint32_t index = 0;  // within the block
  int scatterings = 0;
  bool began_at_flat_mirror = false;
  PathClass events;
};

/// Light on its way to the eye by a flat mirror.
template <TracesFromLights T>
struct MirroredCameraRay {
  typename T::Value throughput{};  // from the light up to the mirror
  std::uint32_t path = 0;
  std::uint32_t pixel = 0;
  int plane = 0;
  int path_class = 0;
};

template <TracesFromLights T>
struct LightPathBatch {
  std::vector<LightPath<T>> paths;
  std::vector<std::uint32_t> active;
  std::vector<Ray> rays;
  std::vector<Hit> hits;
  std::vector<Ray> mirror_rays;
  std::vector<Hit> mirror_hits;
  std::vector<MirroredCameraRay<T>> mirror_ray_payloads;
  std::vector<Ray> camera_rays;
  std::vector<Splat> queries;  // arrive when nothing is in between
  std::vector<std::uint8_t> blocked;
  std::vector<Splat> splats;  // the result
  double traversal_seconds = 0;
};

/// Where the camera sees a point: pixel, and the factor from the area of the surface to the pixel's mean.
struct CameraProjection {
  std::uint32_t pixel = 0;
  float importance = 0;  // per m^2 of surface that faces the camera; 0 outside the image
};

CameraProjection project(const PinholeCamera& camera, Vec3f point);

/// The camera's image behind the mirror: it sees a point where the camera sees the point's image.
PinholeCamera mirrored(const MirrorPlane& plane, const PinholeCamera& camera);

// f |cos| of the camera's path carries |wi . shading normal|, the light's density on the surface |wi .
// geometric normal|: Veach 1997, 5.3.
inline float surface_cosine(const SurfacePoint& point, Vec3f direction) {
  return std::abs(dot(point.geometric_normal, direction));
}

/// A light path's scattering towards the eye.
template <TracesFromLights T>
struct CameraConnection {
  typename T::Value throughput{};  // of the path with this scattering
  [[no_unique_address]] typename T::Lambda lambda{};
  PathClass events;
  Vec3f origin;  // of the ray to the eye
};

/// At a surface that the path has met, in the direction `to_camera`; `importance` as in CameraProjection.
template <TracesFromLights T>
std::optional<CameraConnection<T>> scattered_to_camera(
    const World& world, const LightPath<T>& path, const SurfaceHit& surface, Vec3f to_camera, float importance) {
  const SurfacePoint& point = surface.point;
  const Vec3f to_light = -path.ray.direction;
  const float side = dot(point.shading_normal, to_camera);
  if (side == 0 || !sides_agree(point.geometric_normal, point.shading_normal, to_light)) return std::nullopt;
  const Frame frame = frame_around(side > 0 ? point.shading_normal : -point.shading_normal);
  const Vec3f wo = frame.to_local(to_camera);
  const Vec3f wi = frame.to_local(to_light);
  if (!(wo.z > 0)) return std::nullopt;
  CameraConnection<T> out;
  out.lambda = path.lambda;
  out.throughput = path.throughput;
  typename T::Bsdf bsdf;
  make_bsdf<T>(bsdf, world, surface, side > 0, {out.lambda, out.throughput, {}});
  const auto value = evaluate(bsdf, wo, wi);
  if (!(value.pdf > 0) || (surface.material.is_near_specular && !(value.pdf < kTailPdf))) return std::nullopt;
  out.events = path.events;
  out.events.add_before(event_of(bsdf), wi.z < 0);
  const float factor = importance * surface_cosine(point, to_camera) / surface_cosine(point, to_light);
  out.throughput = out.throughput * (value.f_cos * factor);
  out.origin = offset_origin(point.position, point.position_error, point.geometric_normal, to_camera);
  return out;
}

template <TracesFromLights T>
void connect_to_camera(LightPathBatch<T>& batch, const World& world, const LightPath<T>& path, const SurfaceHit& surface) {
  const CameraProjection view = project(world.camera, surface.point.position);
  if (!(view.importance > 0)) return;
  const Vec3f to_camera = normalised(world.camera.position - surface.point.position);
  const auto found = scattered_to_camera(world, path, surface, to_camera, view.importance);
  if (!found) return;
  batch.camera_rays.push_back({found->origin, world.camera.position - found->origin, 1});
  batch.queries.push_back(
      {view.pixel, found->events.index(), T::to_rgb(found->throughput * path.emitted, path.lambda)});
}

/// By way of every flat mirror that has both the point and the camera before it.
template <TracesFromLights T>
void connect_to_camera_by_mirrors(LightPathBatch<T>& batch,
                          const World& world,
                          std::uint32_t index,
                          const SurfaceHit& surface) {
  const LightPath<T>& path = batch.paths[index];
  if (path.scatterings + 2 > world.trace_depth) return;  // this one and the mirror
  for (std::size_t i = 0; i < world.mirror_planes.size(); ++i) {
    const MirrorPlane& plane = world.mirror_planes[i];
    // The camera as note_near_specular asks; any point whose ray meets the mirror, for camera paths leave all of
    // them to us.
    if (!is_before(plane, world.camera.position) || !(height_over(plane, surface.point.position) > 0)) continue;
    const PinholeCamera camera = mirrored(plane, world.camera);
    const CameraProjection view = project(camera, surface.point.position);
    if (!(view.importance > 0)) continue;
    const Vec3f to_image = normalised(camera.position - surface.point.position);
    auto found = scattered_to_camera(world, path, surface, to_image, view.importance);
    if (!found) continue;
    found->events.add_before(Event::Specular, false);
    batch.mirror_rays.push_back({found->origin, to_image});
    batch.mirror_ray_payloads.push_back(
        {found->throughput, index, view.pixel, static_cast<int>(i), found->events.index()});
  }
}

/// The queries whose ray meets the mirror go on from there to the eye.
template <TracesFromLights T>
void resolve_mirror_rays(LightPathBatch<T>& batch, const World& world) {
  batch.mirror_hits.resize(batch.mirror_rays.size());
  timed_traversal(batch, [&] { world.accel->intersect(batch.mirror_rays, batch.mirror_hits); });
  for (std::size_t i = 0; i < batch.mirror_ray_payloads.size(); ++i) {
    const MirroredCameraRay<T>& query = batch.mirror_ray_payloads[i];
    const LightPath<T>& path = batch.paths[query.path];
    const auto at_mirror =
        reflection_at<T>(world, batch.mirror_rays[i], batch.mirror_hits[i], query.plane, path.lambda);
    if (!at_mirror) continue;
    const Vec3f to_camera = world.camera.position - at_mirror->point.position;
    const Vec3f origin = offset_origin(at_mirror->point.position, at_mirror->point.position_error,
                                       at_mirror->point.geometric_normal, to_camera);
    const auto through = at_mirror->reflectance * query.throughput;
    batch.camera_rays.push_back({origin, world.camera.position - origin, 1});
    batch.queries.push_back({query.pixel, query.path_class, T::to_rgb(through * path.emitted, path.lambda)});
  }
  batch.mirror_rays.clear();
  batch.mirror_ray_payloads.clear();
}

template <TracesFromLights T>
void resolve_shadow_rays(LightPathBatch<T>& batch, const World& world) {
  batch.blocked.resize(batch.camera_rays.size());
  timed_traversal(batch, [&] { world.accel->occluded(batch.camera_rays, batch.blocked); });
  for (std::size_t i = 0; i < batch.queries.size(); ++i)
    if (batch.blocked[i] == 0) batch.splats.push_back(batch.queries[i]);
}

}  // namespace orbs::tracer

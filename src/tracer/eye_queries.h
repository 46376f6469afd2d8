#pragma once

#include "tracer/emission.h"
#include "tracer/mirrored_light.h"

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
concept TracesFromLights = Transport<T> && std::same_as<typename T::Weight, typename T::Value>;

template <TracesFromLights T>
struct LightPath {
  typename T::Value weight{};   // of all scatterings
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
struct MirroredEyeQuery {
  typename T::Value weight{};  // from the light up to the mirror
  std::uint32_t path = 0;
  std::uint32_t pixel = 0;
  int plane = 0;
  int path_class = 0;
};

template <TracesFromLights T>
struct LightWave {
  std::vector<LightPath<T>> paths;
  std::vector<std::uint32_t> active;
  std::vector<Ray> rays;
  std::vector<Hit> hits;
  std::vector<Ray> mirror_rays;
  std::vector<Hit> mirror_hits;
  std::vector<MirroredEyeQuery<T>> mirror_queries;
  std::vector<Ray> eye_rays;
  std::vector<Splat> queries;  // arrive when nothing is in between
  std::vector<std::uint8_t> blocked;
  std::vector<Splat> splats;  // the result
  double traversal_seconds = 0;
};

/// Where the camera sees a point: pixel, and the factor from the area of the surface to the pixel's mean.
struct EyeView {
  std::uint32_t pixel = 0;
  float importance = 0;  // per m^2 of surface that faces the camera; 0 outside the image
};

EyeView view_of(const PinholeCamera& camera, Vec3f point);

/// The camera's image behind the mirror: it sees a point where the camera sees the point's image.
PinholeCamera mirrored(const MirrorPlane& plane, const PinholeCamera& camera);

// f |cos| of the camera's path carries |wi . shading normal|, the light's density on the surface |wi .
// geometric normal|: Veach 1997, 5.3.
inline float surface_cosine(const SurfacePoint& point, Vec3f direction) {
  return std::abs(dot(point.geometric_normal, direction));
}

/// A light path's scattering towards the eye.
template <TracesFromLights T>
struct TowardsEye {
  typename T::Value weight{};  // of the path with this scattering
  [[no_unique_address]] typename T::Lambda lambda{};
  PathClass events;
  Vec3f origin;  // of the ray to the eye
};

/// At a surface that the path has met, in the direction `to_eye`; `importance` as in EyeView.
template <TracesFromLights T>
std::optional<TowardsEye<T>> scattered_to_eye(
    const World& world, const LightPath<T>& path, const MetSurface& met, Vec3f to_eye, float importance) {
  const SurfacePoint& point = met.point;
  const Vec3f to_light = -path.ray.direction;
  const float side = dot(point.shading_normal, to_eye);
  if (side == 0 || !sides_agree(point.geometric_normal, point.shading_normal, to_light)) return std::nullopt;
  const Frame frame = frame_around(side > 0 ? point.shading_normal : -point.shading_normal);
  const Vec3f wo = frame.to_local(to_eye);
  const Vec3f wi = frame.to_local(to_light);
  if (!(wo.z > 0)) return std::nullopt;
  TowardsEye<T> out;
  out.lambda = path.lambda;
  out.weight = path.weight;
  typename T::Bsdf bsdf;
  place_bsdf<T>(bsdf, world, met, side > 0, {out.lambda, out.weight, {}});
  const auto value = evaluate(bsdf, wo, wi);
  if (!(value.pdf > 0) || (met.material.is_sharp && !(value.pdf < kTailPdf))) return std::nullopt;
  out.events = path.events;
  out.events.add_before(event_of(bsdf), wi.z < 0);
  const float factor = importance * surface_cosine(point, to_eye) / surface_cosine(point, to_light);
  out.weight = out.weight * (value.f_cos * factor);
  out.origin = offset_origin(point.position, point.position_error, point.geometric_normal, to_eye);
  return out;
}

template <TracesFromLights T>
void ask_for_eye(LightWave<T>& wave, const World& world, const LightPath<T>& path, const MetSurface& met) {
  const EyeView view = view_of(world.camera, met.point.position);
  if (!(view.importance > 0)) return;
  const Vec3f to_eye = normalised(world.camera.position - met.point.position);
  const auto found = scattered_to_eye(world, path, met, to_eye, view.importance);
  if (!found) return;
  wave.eye_rays.push_back({found->origin, world.camera.position - found->origin, 1});
  wave.queries.push_back(
      {view.pixel, found->events.index(), T::to_rgb(found->weight * path.emitted, path.lambda)});
}

/// By way of every flat mirror that has both the point and the camera before it.
template <TracesFromLights T>
void ask_for_mirrored_eye(LightWave<T>& wave,
                          const World& world,
                          std::uint32_t index,
                          const MetSurface& met) {
  const LightPath<T>& path = wave.paths[index];
  if (path.scatterings + 2 > world.trace_depth) return;  // this one and the mirror
  for (std::size_t i = 0; i < world.mirror_planes.size(); ++i) {
    const MirrorPlane& plane = world.mirror_planes[i];
    // The camera as note_sharpness asks; any point whose ray meets the mirror, for camera paths leave all of
    // them to us.
    if (!is_before(plane, world.camera.position) || !(height_over(plane, met.point.position) > 0)) continue;
    const PinholeCamera camera = mirrored(plane, world.camera);
    const EyeView view = view_of(camera, met.point.position);
    if (!(view.importance > 0)) continue;
    const Vec3f to_image = normalised(camera.position - met.point.position);
    auto found = scattered_to_eye(world, path, met, to_image, view.importance);
    if (!found) continue;
    found->events.add_before(Event::Specular, false);
    wave.mirror_rays.push_back({found->origin, to_image});
    wave.mirror_queries.push_back(
        {found->weight, index, view.pixel, static_cast<int>(i), found->events.index()});
  }
}

/// The queries whose ray meets the mirror go on from there to the eye.
template <TracesFromLights T>
void reflect_eye_queries(LightWave<T>& wave, const World& world) {
  wave.mirror_hits.resize(wave.mirror_rays.size());
  timed_traversal(wave, [&] { world.accel->intersect(wave.mirror_rays, wave.mirror_hits); });
  for (std::size_t i = 0; i < wave.mirror_queries.size(); ++i) {
    const MirroredEyeQuery<T>& query = wave.mirror_queries[i];
    const LightPath<T>& path = wave.paths[query.path];
    const auto at_mirror =
        reflection_at<T>(world, wave.mirror_rays[i], wave.mirror_hits[i], query.plane, path.lambda);
    if (!at_mirror) continue;
    const Vec3f to_eye = world.camera.position - at_mirror->point.position;
    const Vec3f origin = offset_origin(at_mirror->point.position, at_mirror->point.position_error,
                                       at_mirror->point.geometric_normal, to_eye);
    const auto through = at_mirror->reflectance * query.weight;
    wave.eye_rays.push_back({origin, world.camera.position - origin, 1});
    wave.queries.push_back({query.pixel, query.path_class, T::to_rgb(through * path.emitted, path.lambda)});
  }
  wave.mirror_rays.clear();
  wave.mirror_queries.clear();
}

template <TracesFromLights T>
void settle_eye_queries(LightWave<T>& wave, const World& world) {
  wave.blocked.resize(wave.eye_rays.size());
  timed_traversal(wave, [&] { world.accel->occluded(wave.eye_rays, wave.blocked); });
  for (std::size_t i = 0; i < wave.queries.size(); ++i)
    if (wave.blocked[i] == 0) wave.splats.push_back(wave.queries[i]);
}

}  // namespace orbs::tracer

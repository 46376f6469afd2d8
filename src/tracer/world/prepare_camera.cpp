#include "tracer/world/prepare_camera.h"

#include "scene/camera_frame.h"
#include "scene/geometry/world_bounds.h"
#include "scene/motion.h"

#include <algorithm>
#include <cmath>

namespace orbs::tracer {

namespace {

// The least distance of the camera from a point while it moves.
double least_distance(const scene::Camera& camera, Vec3d point) {
  const Vec3d way = camera.end ? camera.end->position_m - camera.position_m : Vec3d{};
  const double square = dot(way, way);
  const double time = square > 0 ? std::clamp(dot(point - camera.position_m, way) / square, 0.0, 1.0) : 0.0;
  return length(camera.position_m + way * time - point);
}

}  // namespace

Extent extent_of(const scene::Scene& scene) {
  constexpr double kDistant = 16;  // radii: floats lose four bits by the distance
  const scene::Camera& camera = scene.camera;
  const Vec3d eye = camera.position_m;
  const auto drawn = scene::rough_bounds(scene);
  if (!drawn) return {eye};
  const double radius = radius_of(*drawn);
  const Vec3d centre = (drawn->low + drawn->high) * 0.5;
  if (radius > 0 && least_distance(camera, centre) > kDistant * radius) return {centre, radius, true};
  const auto with_eye = joined(*drawn, {eye, eye});
  if (!camera.end) return {eye, radius_of(with_eye)};
  return {eye, radius_of(joined(with_eye, {camera.end->position_m, camera.end->position_m}))};
}

// A step of four to eight radii leaves the origin of a scene that contains it where it is, as the camera is
// then within two radii of it, and no coordinate of a scene elsewhere is above six: its roundings stay below
// 6 * 2^-24 of the radius. The step is 256 m at most, half of which floats resolve to 8e-6 m.
Vec3d origin_near(const Extent& extent) {
  constexpr double kMostStep_m = 256;
  const double step = extent.radius_m > 0
                          ? std::min(kMostStep_m, std::exp2(std::ceil(std::log2(4 * extent.radius_m))))
                          : kMostStep_m;
  const auto nearest = [&](double m) { return step * std::round(m / step); };
  return {nearest(extent.centre.x), nearest(extent.centre.y), nearest(extent.centre.z)};
}

PinholeCamera prepare_camera(const scene::Camera& camera, const Extent& extent, Vec3d origin) {
  const auto frame = scene::camera_frame(camera);
  const Vec3d position = camera.position_m - origin;
  const Vec3d right = frame.right * frame.half_width;
  const Vec3d up = frame.up * frame.half_height;
  PinholeCamera prepared{cast<float>(position), cast<float>(frame.forward),
                         cast<float>(right),    cast<float>(up),
                         camera.width_px,       camera.height_px};
  // By the triangle inequality a point that is nearer is more than two radii from the middle of the scene.
  if (extent.camera_is_distant)
    prepared.distant = {position, frame.forward, right, up,
                        length(camera.position_m - extent.centre) - 2 * extent.radius_m};
  return prepared;
}

PinholeCamera camera_at(const MovingCamera& moving, const PinholeCamera& start, float time) {
  const auto camera = scene::camera_at(moving.camera, static_cast<double>(time));
  auto prepared = prepare_camera(camera, moving.extent, moving.origin);
  prepared.width = start.width;
  prepared.height = start.height;
  return prepared;
}

}  // namespace orbs::tracer

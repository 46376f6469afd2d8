#include "tracer/world/camera.h"

#include "tracer/numeric_fault.h"

#include <limits>

namespace orbs::tracer {

namespace {

Ray distant_ray(const DistantCamera& camera, double sx, double sy) {
  const Vec3d direction = normalised(camera.forward + camera.right * sx + camera.up * sy);
  return {cast<float>(camera.position + direction * camera.start_m), cast<float>(direction)};
}

}  // namespace

Ray camera_ray(const PinholeCamera& camera, float x, float y) {
  const float sx = 2 * x / static_cast<float>(camera.width) - 1;
  const float sy = 1 - 2 * y / static_cast<float>(camera.height);
  if (camera.distant) return distant_ray(*camera.distant, static_cast<double>(sx), static_cast<double>(sy));
  Ray ray{camera.position, normalised(camera.forward + camera.right * sx + camera.up * sy)};
  // A camera that lies on a floor and looks away from it would see that floor at distance zero in every
  // direction. Other rays keep such hits: where one starts at an edge, they are what closes the room.
  if (!has_fault(NumericFault::HitsAtZeroSeenByCamera)) ray.nearest = std::numeric_limits<float>::min();
  constexpr float kMicrometre = 1e-6F;
  if (has_fault(NumericFault::CameraRaysStartBehind)) ray.origin = ray.origin - ray.direction * kMicrometre;
  return ray;
}

CameraProjection project(const PinholeCamera& camera, Vec3f point) {
  const Vec3f d = point - camera.position;
  const float depth = dot(d, camera.forward);
  if (!(depth > 0)) return {};
  const Vec3f on_plane = d / depth;
  const float half_width = length(camera.right);
  const float half_height = length(camera.up);
  const float x =
      (dot(on_plane, camera.right) / (half_width * half_width) + 1) / 2 * static_cast<float>(camera.width);
  const float y =
      (1 - dot(on_plane, camera.up) / (half_height * half_height)) / 2 * static_cast<float>(camera.height);
  if (!(x >= 0 && y >= 0 && x < static_cast<float>(camera.width) && y < static_cast<float>(camera.height)))
    return {};
  const auto pixel = static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(camera.width) +
                     static_cast<std::uint32_t>(x);
  // A surface element dA at distance r, perpendicular to the ray, subtends dA / r^2, which projects to
  // dA / (r^2 cos^3) on the image plane at distance 1. The pixel averages over its own area of that plane.
  const float distance = length(d);
  const float cosine = depth / distance;
  const float pixels_per_area =
      static_cast<float>(camera.width) * static_cast<float>(camera.height) / (4 * half_width * half_height);
  return {pixel, pixels_per_area / (distance * distance * cosine * cosine * cosine)};
}

PinholeCamera mirrored(const MirrorPlane& plane, const PinholeCamera& camera) {
  PinholeCamera out = camera;
  out.position = mirrored(plane, camera.position);
  out.forward = mirrored_direction(plane, camera.forward);
  out.right = mirrored_direction(plane, camera.right);
  out.up = mirrored_direction(plane, camera.up);
  return out;
}

}  // namespace orbs::tracer

#include "tracer/world/camera.h"

#include "tracer/numeric_fault.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace orbs::tracer {

namespace {

Ray distant_ray(const CameraKind& kind, const DistantCamera& camera, double x, double y) {
  const auto [origin, along] = std::visit([&](const auto& one) { return film_ray(one, camera, x, y); }, kind);
  const Vec3d direction = normalised(along);
  return {cast<float>(origin + direction * camera.start_m), cast<float>(direction)};
}

}  // namespace

Ray camera_ray(const Camera& camera, float x, float y) {
  const float sx = 2 * x / static_cast<float>(camera.width) - 1;
  const float sy = 1 - 2 * y / static_cast<float>(camera.height);
  if (camera.distant)
    return distant_ray(camera.kind, *camera.distant, static_cast<double>(sx), static_cast<double>(sy));
  const auto [origin, along] =
      std::visit([&](const auto& kind) { return film_ray(kind, camera, sx, sy); }, camera.kind);
  Ray ray{origin, normalised(along)};
  // A camera that lies on a floor and looks away from it would see that floor at distance zero in every
  // direction. Other rays keep such hits: where one starts at an edge, they are what closes the room.
  if (!has_fault(NumericFault::HitsAtZeroSeenByCamera)) ray.nearest = std::numeric_limits<float>::min();
  constexpr float kMicrometre = 1e-6F;
  if (has_fault(NumericFault::CameraRaysStartBehind)) ray.origin = ray.origin - ray.direction * kMicrometre;
  return ray;
}

namespace {

template <typename View, typename Real>
void move_to(View& view, const ThinLens& lens, Real x, Real y) {
  const auto aside = normalised(view.right) * (x * static_cast<Real>(lens.radius)) +
                     normalised(view.up) * (y * static_cast<Real>(lens.radius));
  view.position += aside;
  view.centre += aside / -static_cast<Real>(lens.focus);
}

}  // namespace

Camera seen_through(const Camera& camera, float u, float v) {
  const auto& lens = std::get<ThinLens>(camera.kind);
  Camera out = camera;
  out.kind = Pinhole{};
  const double distance = std::sqrt(static_cast<double>(u));
  const double angle = 2 * std::numbers::pi * static_cast<double>(v);
  const double x = distance * std::cos(angle);
  const double y = distance * std::sin(angle);
  move_to(out, lens, static_cast<float>(x), static_cast<float>(y));
  if (out.distant) move_to(*out.distant, lens, x, y);
  return out;
}

CameraProjection project(const Camera& camera, Vec3f point) {
  const auto place =
      std::visit([&](const auto& kind) { return film_place(kind, camera, point); }, camera.kind);
  if (!(place.spread > 0)) return {};
  const float x = (place.x + 1) / 2 * static_cast<float>(camera.width);
  const float y = (1 - place.y) / 2 * static_cast<float>(camera.height);
  if (!(x >= 0 && y >= 0 && x < static_cast<float>(camera.width) && y < static_cast<float>(camera.height)))
    return {};
  const auto pixel = static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(camera.width) +
                     static_cast<std::uint32_t>(x);
  const float pixels = static_cast<float>(camera.width) * static_cast<float>(camera.height);
  return {pixel, pixels / place.window / place.spread, place.viewpoint};
}

Vec3f viewpoint_of(const Camera& camera, const Ray& ray) {
  if (std::holds_alternative<Pinhole>(camera.kind)) return camera.position;
  return camera.distant ? ray.origin - ray.direction * static_cast<float>(camera.distant->start_m)
                        : ray.origin;
}

Vec3f image_right(const Camera& camera, const Ray& ray) {
  if (!std::holds_alternative<LatitudeLongitude>(camera.kind)) return camera.right;
  const Vec3f right = cross(ray.direction, camera.up);
  return dot(right, right) > 0 ? right : camera.right;  // a ray to a pole
}

float pixel_width(const Camera& camera, float distance) {
  const float share = 2 / static_cast<float>(camera.width);
  if (std::holds_alternative<LatitudeLongitude>(camera.kind))
    return share * std::numbers::pi_v<float> * distance;
  const float pixel = 2 * length(camera.right) / static_cast<float>(camera.width);
  return std::holds_alternative<Orthographic>(camera.kind) ? pixel : pixel * distance;
}

Camera mirrored(const MirrorPlane& plane, const Camera& camera) {
  Camera out = camera;
  out.position = mirrored(plane, camera.position);
  out.forward = mirrored_direction(plane, camera.forward);
  out.centre = mirrored_direction(plane, camera.centre);
  out.right = mirrored_direction(plane, camera.right);
  out.up = mirrored_direction(plane, camera.up);
  return out;
}

}  // namespace orbs::tracer

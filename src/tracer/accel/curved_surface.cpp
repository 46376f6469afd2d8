#include "tracer/accel/curved_surface.h"

#include "tracer/numeric_fault.h"

#include <cmath>

namespace orbs::tracer {

namespace {

// Distance along the ray to the unit disk y = 0 or the unit sphere in the local space of the shape, in double
// precision because the origin may be far away in units of the shape. Nothing outside (near, far).
std::optional<double> disk_distance(Vec3d o, Vec3d d, double near, double far) {
  const double t = -o.y / d.y;
  if (!(t > near && t < far)) return std::nullopt;
  const double x = o.x + t * d.x;
  const double z = o.z + t * d.z;
  return x * x + z * z <= 1 ? std::optional(t) : std::nullopt;
}

// What NumericFault::NaiveQuadratic does.
std::optional<double> naive_sphere_distance(Vec3f o, Vec3f d, double near, double far) {
  const float a = dot(d, d);
  const float b = 2 * dot(o, d);
  const float discriminant = b * b - 4 * a * (dot(o, o) - 1);
  if (discriminant < 0) return std::nullopt;
  for (const float side : {-1.0F, 1.0F})
    if (const double t = (-b + side * std::sqrt(discriminant)) / (2 * a); t > near && t < far) return t;
  return std::nullopt;
}

std::optional<double> sphere_distance(Vec3d o, Vec3d d, double near, double far) {
  if (has_fault(NumericFault::NaiveQuadratic))
    return naive_sphere_distance(cast<float>(o), cast<float>(d), near, far);
  // Solved from the point of closest approach, as b^2 - 4ac cancels for small distant spheres (Haines et al.
  // 2019, Ray Tracing Gems, ch. 7).
  const double dd = dot(d, d);
  const double middle = -dot(o, d) / dd;
  const Vec3d nearest = o + d * middle;
  const double room = 1 - dot(nearest, nearest);
  if (room < 0) return std::nullopt;
  const double half = std::sqrt(room / dd);
  for (const double t : {middle - half, middle + half})
    if (t > near && t < far) return t;
  return std::nullopt;
}

std::optional<double> distance_to(const CurvedSurface& surface, const UserRay& ray) {
  const auto local = [&](Vec3d v) {
    return Vec3d{dot(surface.inverse_rows[0], v), dot(surface.inverse_rows[1], v),
                 dot(surface.inverse_rows[2], v)};
  };
  const Vec3d o = local(cast<double>(ray.origin) - surface.centre);
  const Vec3d d = local(cast<double>(ray.direction));
  return surface.is_sphere ? sphere_distance(o, d, ray.near, ray.far)
                           : disk_distance(o, d, ray.near, ray.far);
}

}  // namespace

std::array<Vec3d, 3> inverse_rows(Vec3d a, Vec3d b, Vec3d c) {
  const double determinant = dot(a, cross(b, c));
  return {cross(b, c) / determinant, cross(c, a) / determinant, cross(a, b) / determinant};
}

CurvedSurface surface_of(const SphereSurface& sphere) {
  const double r = sphere.radius;
  return {sphere.centre, inverse_rows({r, 0, 0}, {0, r, 0}, {0, 0, r}), true};
}

// The columns of the map are dual to the rows of its inverse. The image of the unit ball extends along a
// world axis by the length of the row of the map for that axis.
UserBounds bounds_of(const CurvedSurface& surface) {
  const auto columns =
      inverse_rows(surface.inverse_rows[0], surface.inverse_rows[1], surface.inverse_rows[2]);
  const Vec3d extent{std::hypot(columns[0].x, columns[1].x, columns[2].x),
                     std::hypot(columns[0].y, columns[1].y, columns[2].y),
                     std::hypot(columns[0].z, columns[1].z, columns[2].z)};
  return {surface.centre - extent, surface.centre + extent};
}

std::optional<Hit> hit_of(const CurvedSurface& surface, unsigned int index, const UserRay& ray) {
  const auto distance = distance_to(surface, ray);
  if (!distance) return std::nullopt;
  Hit hit;
  hit.distance = static_cast<float>(*distance);
  hit.barycentric = {static_cast<float>(*distance - static_cast<double>(hit.distance)), 0};
  hit.primitive = index;
  return hit;
}

}  // namespace orbs::tracer

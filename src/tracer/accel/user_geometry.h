#pragma once

#include "base/vec.h"
#include "tracer/accel/embree_api.h"
#include "tracer/geometry/ray.h"

#include <cmath>
#include <limits>
#include <optional>
#include <span>

namespace orbs::tracer {

/// A ray as the tests of user geometries get it: hits count where near < distance < far.
struct UserRay {
  Vec3f origin;
  Vec3f direction;
  float near = 0;
  float far = 0;
  float time = 0;
};

struct UserBounds {
  Vec3d low;
  Vec3d high;
};

namespace detail {

/// Bounds are floats, so they grow to the next ones.
template <typename Shape>
void user_bounds(const RTCBoundsFunctionArguments* args) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const auto low = [](double x) { return std::nextafter(static_cast<float>(x), -kInfinity); };
  const auto high = [](double x) { return std::nextafter(static_cast<float>(x), kInfinity); };
  const UserBounds bounds = bounds_of(static_cast<const Shape*>(args->geometryUserPtr)[args->primID]);
  RTCBounds& out = *args->bounds_o;
  out.lower_x = low(bounds.low.x);
  out.lower_y = low(bounds.low.y);
  out.lower_z = low(bounds.low.z);
  out.upper_x = high(bounds.high.x);
  out.upper_y = high(bounds.high.y);
  out.upper_z = high(bounds.high.z);
}

inline UserRay user_ray(RTCRayN* rays, unsigned int n, unsigned int i) {
  return {{RTCRayN_org_x(rays, n, i), RTCRayN_org_y(rays, n, i), RTCRayN_org_z(rays, n, i)},
          {RTCRayN_dir_x(rays, n, i), RTCRayN_dir_y(rays, n, i), RTCRayN_dir_z(rays, n, i)},
          RTCRayN_tnear(rays, n, i),
          RTCRayN_tfar(rays, n, i),
          RTCRayN_time(rays, n, i)};
}

template <typename Shape>
void user_intersect(const RTCIntersectFunctionNArguments* args) {
  const Shape& shape = static_cast<const Shape*>(args->geometryUserPtr)[args->primID];
  RTCRayN* rays = RTCRayHitN_RayN(args->rayhit, args->N);
  RTCHitN* hits = RTCRayHitN_HitN(args->rayhit, args->N);
  for (unsigned int i = 0; i < args->N; ++i) {
    if (args->valid[i] == 0) continue;
    const std::optional<Hit> hit = hit_of(shape, args->primID, user_ray(rays, args->N, i));
    if (!hit) continue;
    RTCRayN_tfar(rays, args->N, i) = hit->distance;
    RTCHitN_geomID(hits, args->N, i) = args->geomID;
    RTCHitN_primID(hits, args->N, i) = hit->primitive;
    RTCHitN_instID(hits, args->N, i, 0) = args->context->instID[0];
    RTCHitN_u(hits, args->N, i) = hit->barycentric.x;
    RTCHitN_v(hits, args->N, i) = hit->barycentric.y;
  }
}

template <typename Shape>
void user_occluded(const RTCOccludedFunctionNArguments* args) {
  const Shape& shape = static_cast<const Shape*>(args->geometryUserPtr)[args->primID];
  const auto blocks = [&](const UserRay& ray) {
    if constexpr (requires { is_blocked(shape, args->primID, ray); })
      return is_blocked(shape, args->primID, ray);
    else
      return hit_of(shape, args->primID, ray).has_value();
  };
  for (unsigned int i = 0; i < args->N; ++i)
    if (args->valid[i] != 0 && blocks(user_ray(args->ray, args->N, i)))
      RTCRayN_tfar(args->ray, args->N, i) = -std::numeric_limits<float>::infinity();
}

}  // namespace detail

/// Shapes with own intersection tests as a geometry of Embree. `shapes` must outlive it and must not move.
/// Found by argument-dependent lookup: UserBounds bounds_of(const Shape&), in world space, and
/// std::optional<Hit> hit_of(const Shape&, unsigned int index, const UserRay&), where index is that of the
/// shape; and, where any hit is found faster than the nearest one, bool is_blocked(const Shape&, unsigned
/// int, const UserRay&).
template <typename Shape>
RTCGeometry make_user_geometry(RTCDevice device, std::span<const Shape> shapes) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned int>(shapes.size()));
  // Embree hands the pointer back as one to non-const; the functions above do not change the shapes.
  rtcSetGeometryUserData(geometry, const_cast<Shape*>(shapes.data()));
  rtcSetGeometryBoundsFunction(
      geometry, [](const RTCBoundsFunctionArguments* args) { detail::user_bounds<Shape>(args); }, nullptr);
  rtcSetGeometryIntersectFunction(geometry, detail::user_intersect<Shape>);
  rtcSetGeometryOccludedFunction(geometry, detail::user_occluded<Shape>);
  return geometry;
}

}  // namespace orbs::tracer

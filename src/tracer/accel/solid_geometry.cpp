#include "tracer/accel/solid_geometry.h"

#include "tracer/shapes/solid_hit.h"

#include <cmath>
#include <limits>
#include <optional>

namespace orbs::tracer {

namespace {

void solid_bounds(const RTCBoundsFunctionArguments* args) {
  const auto& solid = *static_cast<const Solid*>(args->geometryUserPtr);
  const auto low = [](double x) {
    return std::nextafter(static_cast<float>(x), -std::numeric_limits<float>::infinity());
  };
  const auto high = [](double x) {
    return std::nextafter(static_cast<float>(x), std::numeric_limits<float>::infinity());
  };
  RTCBounds& out = *args->bounds_o;
  out.lower_x = low(solid.low.x);
  out.lower_y = low(solid.low.y);
  out.lower_z = low(solid.low.z);
  out.upper_x = high(solid.high.x);
  out.upper_y = high(solid.high.y);
  out.upper_z = high(solid.high.z);
}

std::optional<Hit> hit_of(const Solid& solid, RTCRayN* rays, unsigned int n, unsigned int i) {
  return intersect(solid, {RTCRayN_org_x(rays, n, i), RTCRayN_org_y(rays, n, i), RTCRayN_org_z(rays, n, i)},
                   {RTCRayN_dir_x(rays, n, i), RTCRayN_dir_y(rays, n, i), RTCRayN_dir_z(rays, n, i)},
                   RTCRayN_tnear(rays, n, i), RTCRayN_tfar(rays, n, i));
}

void solid_intersect(const RTCIntersectFunctionNArguments* args) {
  const auto& solid = *static_cast<const Solid*>(args->geometryUserPtr);
  RTCRayN* rays = RTCRayHitN_RayN(args->rayhit, args->N);
  RTCHitN* hits = RTCRayHitN_HitN(args->rayhit, args->N);
  for (unsigned int i = 0; i < args->N; ++i) {
    if (args->valid[i] == 0) continue;
    const auto hit = hit_of(solid, rays, args->N, i);
    if (!hit) continue;
    RTCRayN_tfar(rays, args->N, i) = hit->distance;
    RTCHitN_geomID(hits, args->N, i) = args->geomID;
    RTCHitN_primID(hits, args->N, i) = hit->primitive;
    RTCHitN_instID(hits, args->N, i, 0) = args->context->instID[0];
    RTCHitN_u(hits, args->N, i) = hit->barycentric.x;
    RTCHitN_v(hits, args->N, i) = 0;
  }
}

void solid_occluded(const RTCOccludedFunctionNArguments* args) {
  const auto& solid = *static_cast<const Solid*>(args->geometryUserPtr);
  for (unsigned int i = 0; i < args->N; ++i)
    if (args->valid[i] != 0 && hit_of(solid, args->ray, args->N, i))
      RTCRayN_tfar(args->ray, args->N, i) = -std::numeric_limits<float>::infinity();
}

}  // namespace

RTCGeometry make_solid_geometry(RTCDevice device, const Solid& solid) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, 1);
  // Embree hands the pointer back as one to non-const; the functions above do not change the shape.
  rtcSetGeometryUserData(geometry, const_cast<Solid*>(&solid));
  rtcSetGeometryBoundsFunction(
      geometry, [](const RTCBoundsFunctionArguments* args) { solid_bounds(args); }, nullptr);
  rtcSetGeometryIntersectFunction(geometry, solid_intersect);
  rtcSetGeometryOccludedFunction(geometry, solid_occluded);
  return geometry;
}

}  // namespace orbs::tracer

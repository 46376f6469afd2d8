#include "tracer/accel/double_triangles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace orbs::tracer {

namespace {

using Triangles = std::vector<DoubleTriangle>;
using Components = std::array<double, 3>;

Components components(Vec3d v) { return {v.x, v.y, v.z}; }

struct Shear {
  std::array<std::size_t, 3> axes{};  // the last is the direction's largest component
  double x = 0, y = 0, z = 0;
};

Shear shear_along(Vec3d direction) {
  Shear shear;
  const Components d = components(direction);
  const auto* largest = std::max_element(
      d.begin(), d.end(), [](double left, double right) { return std::fabs(left) < std::fabs(right); });
  const auto axis = static_cast<std::size_t>(largest - d.begin());
  shear.axes = {(axis + 1) % 3, (axis + 2) % 3, axis};
  const double along = d[axis];
  shear.x = d[shear.axes[0]] / along;
  shear.y = d[shear.axes[1]] / along;
  shear.z = 1 / along;
  return shear;
}

// Bounds are floats, so they grow to the next ones.
void triangle_bounds(const RTCBoundsFunctionArguments* args) {
  const auto& triangle = (*static_cast<const Triangles*>(args->geometryUserPtr))[args->primID];
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const auto low = [&](double Vec3d::*axis) {
    const double least = std::min({triangle[0].*axis, triangle[1].*axis, triangle[2].*axis});
    return std::nextafter(static_cast<float>(least), -kInfinity);
  };
  const auto high = [&](double Vec3d::*axis) {
    const double most = std::max({triangle[0].*axis, triangle[1].*axis, triangle[2].*axis});
    return std::nextafter(static_cast<float>(most), kInfinity);
  };
  RTCBounds& out = *args->bounds_o;
  out.lower_x = low(&Vec3d::x);
  out.lower_y = low(&Vec3d::y);
  out.lower_z = low(&Vec3d::z);
  out.upper_x = high(&Vec3d::x);
  out.upper_y = high(&Vec3d::y);
  out.upper_z = high(&Vec3d::z);
}

std::optional<TriangleHit> hit_of(
    const void* triangles, unsigned int index, RTCRayN* rays, unsigned int n, unsigned int i) {
  return intersect(
      (*static_cast<const Triangles*>(triangles))[index],
      cast<double>(Vec3f{RTCRayN_org_x(rays, n, i), RTCRayN_org_y(rays, n, i), RTCRayN_org_z(rays, n, i)}),
      cast<double>(Vec3f{RTCRayN_dir_x(rays, n, i), RTCRayN_dir_y(rays, n, i), RTCRayN_dir_z(rays, n, i)}),
      static_cast<double>(RTCRayN_tnear(rays, n, i)), static_cast<double>(RTCRayN_tfar(rays, n, i)));
}

void triangle_intersect(const RTCIntersectFunctionNArguments* args) {
  RTCRayN* rays = RTCRayHitN_RayN(args->rayhit, args->N);
  RTCHitN* hits = RTCRayHitN_HitN(args->rayhit, args->N);
  for (unsigned int i = 0; i < args->N; ++i) {
    if (args->valid[i] == 0) continue;
    const auto hit = hit_of(args->geometryUserPtr, args->primID, rays, args->N, i);
    if (!hit) continue;
    RTCRayN_tfar(rays, args->N, i) = static_cast<float>(hit->distance);
    RTCHitN_geomID(hits, args->N, i) = args->geomID;
    RTCHitN_primID(hits, args->N, i) = args->primID;
    RTCHitN_instID(hits, args->N, i, 0) = args->context->instID[0];
    RTCHitN_u(hits, args->N, i) = static_cast<float>(hit->uv[0]);
    RTCHitN_v(hits, args->N, i) = static_cast<float>(hit->uv[1]);
  }
}

void triangle_occluded(const RTCOccludedFunctionNArguments* args) {
  for (unsigned int i = 0; i < args->N; ++i)
    if (args->valid[i] != 0 && hit_of(args->geometryUserPtr, args->primID, args->ray, args->N, i))
      RTCRayN_tfar(args->ray, args->N, i) = -std::numeric_limits<float>::infinity();
}

Vec3d to_world(const Affine& map, Vec3d p) {
  return cast<double>(map.axes[0]) * p.x + cast<double>(map.axes[1]) * p.y + cast<double>(map.axes[2]) * p.z +
         cast<double>(map.offset);
}

}  // namespace

std::optional<TriangleHit> intersect(
    const DoubleTriangle& triangle, Vec3d origin, Vec3d direction, double near, double far) {
  const Shear shear = shear_along(direction);
  std::array<Components, 3> corner{};  // in the space where the ray is the z axis
  for (std::size_t i = 0; i < 3; ++i) {
    const Components p = components(triangle[i] - origin);
    const double along = p[shear.axes[2]];
    corner[i] = {p[shear.axes[0]] - shear.x * along, p[shear.axes[1]] - shear.y * along, shear.z * along};
  }
  const auto& [a, b, c] = corner;
  const double u = c[0] * b[1] - c[1] * b[0];
  const double v = a[0] * c[1] - a[1] * c[0];
  const double w = b[0] * a[1] - b[1] * a[0];
  if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return std::nullopt;
  const double determinant = u + v + w;
  if (determinant == 0) return std::nullopt;  // the triangle is seen edge-on
  const double distance = (u * a[2] + v * b[2] + w * c[2]) / determinant;
  if (!(distance > near && distance < far)) return std::nullopt;
  return TriangleHit{distance, {v / determinant, w / determinant}};
}

std::vector<DoubleTriangle> world_triangles(const RenderObject& object, const TriangleMesh& mesh) {
  Triangles triangles;
  triangles.reserve(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    DoubleTriangle triangle;
    const bool is_degenerate = mesh.triangle_cache[i].geometric_normal == Vec3f{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const auto vertex = mesh.triangles[i][is_degenerate ? 0 : corner];
      triangle[corner] = cast<double>(mesh.positions[vertex]);
      if (object.kind == ObjectKind::InstancedMesh)
        triangle[corner] = to_world(object.to_world, triangle[corner]);
    }
    triangles.push_back(triangle);
  }
  return triangles;
}

RTCGeometry make_double_geometry(RTCDevice device, const std::vector<DoubleTriangle>& triangles) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned int>(triangles.size()));
  // Embree hands the pointer back as one to non-const; the functions above do not change the triangles.
  rtcSetGeometryUserData(geometry, const_cast<Triangles*>(&triangles));
  rtcSetGeometryBoundsFunction(
      geometry, [](const RTCBoundsFunctionArguments* args) { triangle_bounds(args); }, nullptr);
  rtcSetGeometryIntersectFunction(geometry, triangle_intersect);
  rtcSetGeometryOccludedFunction(geometry, triangle_occluded);
  return geometry;
}

}  // namespace orbs::tracer

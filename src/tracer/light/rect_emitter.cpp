#include "tracer/light/rect_emitter.h"

#include "base/in_double.h"
#include "base/vec.h"
#include "tracer/numeric_fault.h"
#include "tracer/sampling/warps.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace orbs::tracer {

namespace {

// A rectangle projected on the unit sphere around `from`, for uniform sampling by solid angle (Urena,
// Fajardo, King 2013, "An Area-Preserving Parametrization for Spherical Rectangles").
struct SphericalRectangle {
  Vec3f from;
  Vec3f x;  // unit axes: along width, along length, and away from `from`
  Vec3f y;
  Vec3f z;
  float x0 = 0;
  float x1 = 0;
  float y0 = 0;
  float y1 = 0;
  float z0 = 0;  // negative distance of the plane
  float b0 = 0;
  float b1 = 0;
  float k = 0;
  float solid_angle = 0;
};

// Of centre +- half_width +- half_length, at a right angle. Nothing if the solid angle is below 1e-2 sr,
// where the sum of four angles minus 2 pi has fewer than four significant digits in float.
std::optional<SphericalRectangle> make_spherical_rectangle(Vec3d centre,
                                                           Vec3d half_width,
                                                           Vec3d half_length,
                                                           Vec3f from) {
  SphericalRectangle r;
  r.from = from;
  const double width = 2 * length(half_width);
  const double height = 2 * length(half_length);
  const Vec3d x = half_width * (2 / width);
  const Vec3d y = half_length * (2 / height);
  const Vec3d z = cross(x, y);
  const Vec3d d = centre - half_width - half_length - cast<double>(from);
  const double along_z = dot(d, z);
  r.x = cast<float>(x);
  r.y = cast<float>(y);
  r.z = cast<float>(along_z > 0 ? -z : z);
  r.z0 = -static_cast<float>(std::abs(along_z));
  if (r.z0 == 0) return std::nullopt;  // seen edge-on
  r.x0 = static_cast<float>(dot(d, x));
  r.y0 = static_cast<float>(dot(d, y));
  r.x1 = static_cast<float>(dot(d, x) + width);
  r.y1 = static_cast<float>(dot(d, y) + height);
  // z components of the normals of the four side planes: -coordinate / hypot(z0, coordinate).
  const auto plane = [&](float coordinate) { return coordinate / in_double::hypot(r.z0, coordinate); };
  const float n0 = -plane(r.y0);
  const float n1 = plane(r.x1);
  const float n2 = plane(r.y1);
  const float n3 = -plane(r.x0);
  // The clamp is for rounding only.
  const auto angle = [](float a, float b) { return in_double::acos(std::clamp(-a * b, -1.0F, 1.0F)); };
  const float g0 = angle(n0, n1);
  const float g1 = angle(n1, n2);
  const float g2 = angle(n2, n3);
  const float g3 = angle(n3, n0);
  r.b0 = n0;
  r.b1 = n2;
  r.k = 2 * kPi - g2 - g3;
  r.solid_angle = g0 + g1 - r.k;
  if (!(r.solid_angle > (has_fault(NumericFault::SolidAngleByAngles) ? 0 : 1e-2F))) return std::nullopt;
  return r;
}

// World position for (u, v) in [0, 1)^2.
Vec3f sample_point(const SphericalRectangle& r, float u, float v) {
  const float au = u * r.solid_angle + r.k;
  const float fu = (in_double::cos(au) * r.b0 - r.b1) / in_double::sin(au);
  // The clamps below are for rounding only: the exact values lie within the edges (Urena et al. 2013, 4.1).
  const float cu = std::clamp(std::copysign(1 / std::sqrt(fu * fu + r.b0 * r.b0), fu), -1.0F, 1.0F);
  const float xu = std::clamp(-(cu * r.z0) / std::sqrt(std::max(1e-12F, 1 - cu * cu)), r.x0, r.x1);
  const float d2 = xu * xu + r.z0 * r.z0;
  const float d = std::sqrt(d2);
  const float h0 = r.y0 / std::sqrt(d2 + r.y0 * r.y0);
  const float h1 = r.y1 / std::sqrt(d2 + r.y1 * r.y1);
  const float hv = h0 + v * (h1 - h0);
  const float yv = hv * hv < 1 - 1e-6F ? hv * d / std::sqrt(1 - hv * hv) : r.y1;
  return r.from + r.x * xu + r.y * std::clamp(yv, r.y0, r.y1) + r.z * r.z0;
}

Vec3f absolute(Vec3d v) { return cast<float>(Vec3d{std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// Closer than two side lengths 1/d^2 varies by more than a factor of 4 over the rectangle, and area sampling
// spends most samples on its far end.
std::optional<SphericalRectangle> near_rectangle(const RectEmitter& rect, Vec3f from) {
  const Vec3f d = cast<float>(rect.centre) - from;
  const bool is_near = dot(d, d) <= 4 * rect.area || has_fault(NumericFault::SolidAngleByAngles);
  if (!rect.is_orthogonal || !is_near) return std::nullopt;
  return make_spherical_rectangle(rect.centre, rect.a, rect.b, from);
}

Vec3f place(const RectEmitter& rect, float u, float v) {
  return cast<float>(rect.centre + rect.a * static_cast<double>(2 * u - 1) +
                     rect.b * static_cast<double>(2 * v - 1));
}

}  // namespace

RectEmitter make_emitter(const scene::RectShape& rect, const Mat4& matrix, Vec3d normal) {
  RectEmitter out{.centre = transform_point(matrix, {}),
                  .a = transform_direction(matrix, {rect.half_width_m, 0, 0}),
                  .b = transform_direction(matrix, {0, 0, rect.half_length_m}),
                  .normal = normal};
  out.area = static_cast<float>(4 * length(cross(out.a, out.b)));
  out.is_orthogonal = std::abs(dot(out.a, out.b)) <= 1e-5 * length(out.a) * length(out.b);
  return out;
}

Quad surface_of(const RectEmitter& rect) {
  return {{rect.centre - rect.a - rect.b, rect.centre + rect.a - rect.b, rect.centre + rect.a + rect.b,
           rect.centre - rect.a + rect.b}};
}

std::optional<EmitterPoint> sample_towards(const RectEmitter& rect, Vec3f from, float u, float v) {
  const float error = rounding_of(rect);
  const Vec3f normal = cast<float>(rect.normal);
  if (dot(rect.normal, cast<double>(from) - rect.centre) <= 0) return std::nullopt;
  if (const auto spherical = near_rectangle(rect, from))
    return EmitterPoint{sample_point(*spherical, u, v), normal, 1 / spherical->solid_angle, error};
  return point_by_area(from, place(rect, u, v), normal, rect.area, error);
}

float pdf_towards(const RectEmitter& rect, Vec3f from, Vec3f position) {
  if (const auto spherical = near_rectangle(rect, from)) return 1 / spherical->solid_angle;
  return area_to_solid_angle(from, position, cast<float>(rect.normal), rect.area);
}

EmittingPoint point_on(const RectEmitter& rect, float u, float v) {
  return {place(rect, u, v), cast<float>(rect.normal), 1 / rect.area, rounding_of(rect), {}};
}

float pdf_area(const RectEmitter& rect, Vec3f) { return 1 / rect.area; }

Vec3f normal_of(const RectEmitter& rect, Vec3f) { return cast<float>(rect.normal); }

bool shows_bright_side(const RectEmitter& rect, Vec3f, Vec3f to_viewer) {
  return dot(rect.normal, cast<double>(to_viewer)) > 0;
}

float rounding_of(const RectEmitter& rect) { return rounding_of(rect.centre, rect.a, rect.b); }

LightBounds bounds_of(const RectEmitter& rect, float power) {
  return flat_bounds(cast<float>(rect.centre), absolute(rect.a) + absolute(rect.b), cast<float>(rect.normal),
                     power);
}

}  // namespace orbs::tracer

#include "tracer/light/rect_emitter.h"

#include "tracer/light/spherical_rectangle.h"

namespace orbs::tracer {

namespace {

Vec3f absolute(Vec3f v) { return {std::abs(v.x), std::abs(v.y), std::abs(v.z)}; }

// Closer than two side lengths 1/d^2 varies by more than a factor of 4 over the rectangle, and area sampling
// spends most samples on its far end.
std::optional<SphericalRectangle> near_rectangle(const RectEmitter& rect, Vec3f from) {
  const Vec3f d = rect.centre - from;
  if (!rect.is_orthogonal || dot(d, d) > 4 * rect.area) return std::nullopt;
  return make_spherical_rectangle(rect.centre, rect.a, rect.b, from);
}

Vec3f place(const RectEmitter& rect, float u, float v) {
  return rect.centre + rect.a * (2 * u - 1) + rect.b * (2 * v - 1);
}

}  // namespace

RectEmitter make_emitter(const scene::RectShape& rect, const Mat4& matrix, Vec3f normal) {
  RectEmitter out{.centre = cast<float>(transform_point(matrix, {})),
                  .a = direction_of(matrix, {rect.half_width_m, 0, 0}),
                  .b = direction_of(matrix, {0, 0, rect.half_length_m}),
                  .normal = normal};
  out.area = 4 * length(cross(out.a, out.b));
  out.is_orthogonal = std::abs(dot(out.a, out.b)) <= 1e-5F * length(out.a) * length(out.b);
  return out;
}

Quad surface_of(const RectEmitter& rect) {
  return {{rect.centre - rect.a - rect.b, rect.centre + rect.a - rect.b, rect.centre + rect.a + rect.b,
           rect.centre - rect.a + rect.b}};
}

std::optional<EmitterPoint> sample_towards(const RectEmitter& rect, Vec3f from, float u, float v) {
  const float error = rounding_of(rect);
  if (dot(rect.normal, from - rect.centre) <= 0) return std::nullopt;
  if (const auto spherical = near_rectangle(rect, from))
    return EmitterPoint{sample_point(*spherical, u, v), rect.normal, 1 / spherical->solid_angle, error};
  return point_by_area(from, place(rect, u, v), rect.normal, rect.area, error);
}

float pdf_towards(const RectEmitter& rect, Vec3f from, Vec3f position) {
  if (const auto spherical = near_rectangle(rect, from)) return 1 / spherical->solid_angle;
  return area_to_solid_angle(from, position, rect.normal, rect.area);
}

EmittingPoint point_on(const RectEmitter& rect, float u, float v) {
  return {place(rect, u, v), rect.normal, 1 / rect.area, rounding_of(rect), {}};
}

float pdf_area(const RectEmitter& rect, Vec3f) { return 1 / rect.area; }

Vec3f normal_of(const RectEmitter& rect, Vec3f) { return rect.normal; }

bool shows_bright_side(const RectEmitter& rect, Vec3f, Vec3f to_viewer) {
  return dot(rect.normal, to_viewer) > 0;
}

float rounding_of(const RectEmitter& rect) { return rounding_of(rect.centre, rect.a, rect.b); }

LightBounds bounds_of(const RectEmitter& rect, float power) {
  return flat_bounds(rect.centre, absolute(rect.a) + absolute(rect.b), rect.normal, power);
}

}  // namespace orbs::tracer

#include "tracer/light/triangle_emitter.h"

#include "tracer/sampling/warps.h"

#include <algorithm>

namespace orbs::tracer {

namespace {

Vec2f interpolated_uv(const TriangleEmitter& t, Vec2f b) {
  return {t.uvs[0].x * (1 - b.x - b.y) + t.uvs[1].x * b.x + t.uvs[2].x * b.y,
          t.uvs[0].y * (1 - b.x - b.y) + t.uvs[1].y * b.x + t.uvs[2].y * b.y};
}

}  // namespace

std::optional<EmitterPoint> sample_towards(const TriangleEmitter& t,
                                           Vec3f from,
                                           Vec2f uv,
                                           Vec2f& texture_uv) {
  const Vec2f b = triangle_point(uv);
  const Vec3f position = t.corner + t.edge1 * b.x + t.edge2 * b.y;
  texture_uv = interpolated_uv(t, b);
  const Vec3f normal = dot(t.normal, from - position) < 0 ? -t.normal : t.normal;
  return point_by_area(from, position, normal, t.area, rounding_of(t));
}

EmittingPoint point_on(const TriangleEmitter& t, float u, float v, float side) {
  const Vec2f b = triangle_point({u, v});
  return {t.corner + t.edge1 * b.x + t.edge2 * b.y, side < 0.5F ? t.normal : -t.normal, 0.5F / t.area,
          rounding_of(t), interpolated_uv(t, b)};
}

float rounding_of(const TriangleEmitter& t) { return rounding_of(t.corner, t.edge1, t.edge2); }

LightBounds bounds_of(const TriangleEmitter& t, float power) {
  const Vec3f b = t.corner + t.edge1;
  const Vec3f c = t.corner + t.edge2;
  const auto least = [](float x, float y, float z) { return std::min({x, y, z}); };
  const auto most = [](float x, float y, float z) { return std::max({x, y, z}); };
  LightBounds out{
      .low = {least(t.corner.x, b.x, c.x), least(t.corner.y, b.y, c.y), least(t.corner.z, b.z, c.z)},
      .high = {most(t.corner.x, b.x, c.x), most(t.corner.y, b.y, c.y), most(t.corner.z, b.z, c.z)},
      .axis = t.normal,
      .cos_spread = 1,
      .is_two_sided = true,
      .power = power};
  for (const Vec3f corner : {t.corner, b, c})
    out.radius = std::max(out.radius, length(corner - centre_of(out)));
  return out;
}

}  // namespace orbs::tracer

#pragma once

#include "base/vec.h"

#include <cmath>
#include <optional>

namespace orbs::tracer {

/// How a point of a triangle moves with its texture coordinates: `scale` times these, in metres.
struct UvDirections {
  Vec3f along_u;
  Vec3f along_v;
  float scale = 1;
};

/// Of the triangle with these edges from its first corner, and the coordinates of their ends less those of
/// the corner; nothing where the coordinates are all on one line.
inline std::optional<UvDirections> uv_directions(Vec3f edge1, Vec3f edge2, Vec2f uv1, Vec2f uv2) {
  // The edges are e = p_u u + p_v v.
  const float area = uv1.x * uv2.y - uv2.x * uv1.y;
  if (area == 0 || !std::isfinite(1 / area)) return std::nullopt;
  const float sign = area < 0 ? -1 : 1;
  return UvDirections{(edge1 * uv2.y - edge2 * uv1.y) * sign, (edge2 * uv1.x - edge1 * uv2.x) * sign,
                      1 / std::fabs(area)};
}

/// Unit vectors perpendicular to a normal: along increasing u, and across that to the side of increasing v.
/// So a mirror image of the surface, and coordinates that are mirrored on it, have the other handedness.
struct TangentFrame {
  Vec3f along_u;
  Vec3f along_v;
};

inline std::optional<TangentFrame> tangent_frame(Vec3f normal, const UvDirections& directions) {
  const Vec3f per_u = directions.along_u * directions.scale;
  const Vec3f in_plane = per_u - normal * dot(normal, per_u);
  const float size = length(in_plane);
  if (!(size > 0)) return std::nullopt;
  const Vec3f along_u = in_plane * (1 / size);
  const Vec3f across = cross(normal, along_u);
  return TangentFrame{along_u, dot(across, directions.along_v) < 0 ? -across : across};
}

}  // namespace orbs::tracer

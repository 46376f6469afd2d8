#pragma once

#include "tracer/colour/texture.h"
#include "tracer/geometry/ray.h"
#include "tracer/geometry/render_object.h"

namespace orbs::tracer {

/// Where a texture is looked up at a hit on a mesh: the coordinates of the map's set, mapped.
inline Vec2f uv_at(const TriangleMesh& mesh, const Hit& hit, const UvMap& map) {
  const std::vector<Vec2f>& uvs = uvs_of(mesh, map.set);
  const auto& corners = mesh.triangles[hit.primitive];
  const float b1 = hit.barycentric.x;
  const float b2 = hit.barycentric.y;
  const float b0 = 1 - b1 - b2;
  const Vec2f t0 = uvs[corners[0]];
  const Vec2f t1 = uvs[corners[1]];
  const Vec2f t2 = uvs[corners[2]];
  return apply(map, {b0 * t0.x + b1 * t1.x + b2 * t2.x, b0 * t0.y + b1 * t1.y + b2 * t2.y});
}

}  // namespace orbs::tracer

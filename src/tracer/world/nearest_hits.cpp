#include "tracer/world/nearest_hits.h"

#include "tracer/world/edge_distance.h"
#include "tracer/world/surface.h"

#include <algorithm>
#include <array>

namespace orbs::tracer {

namespace {

bool may_be_beside_an_edge(const Hit& hit) {
  const auto& [u, v] = hit.barycentric;
  return hit.object != kNoHit && hit.distance > 0 && std::min({u, v, 1 - u - v}) < kMostOfHeight;
}

// Beyond the origin by a quarter of the way, as a surface that is met within rounding may be missed by the
// next ray.
constexpr float kBeyond = 1.25F;

// Whether a surface lies between the origins of rays that leave the two points of the triangle, on either
// side.
bool is_parted(const World& world, const WorldTriangle& triangle, Vec3f safe, Vec3f point, float time) {
  const Vec3f normal = normalised(cross(triangle.edge1, triangle.edge2));
  const auto origin = [&](Vec3f at, Vec3f side) {
    return offset_origin(at, triangle.position_error, normal, side);
  };
  std::array<Ray, 2> rays;
  for (std::size_t i = 0; i < 2; ++i) {
    const Vec3f side = i == 0 ? normal : -normal;
    rays[i].origin = origin(safe, side);
    rays[i].direction = origin(point, side) - rays[i].origin;
    rays[i].reach = kBeyond;
    rays[i].time = time;
  }
  std::array<std::uint8_t, 2> blocked{};
  world.accel->occluded(rays, blocked);
  return blocked[0] != 0 || blocked[1] != 0;
}

void settle(const World& world, const Ray& ray, Hit& hit) {
  const auto triangle = triangle_in_world(world, hit);
  if (!triangle) return;
  const auto change =
      away_from_edges(hit.barycentric, triangle->edge1, triangle->edge2, triangle->position_error);
  if (change == Vec2f{}) return;
  const Vec2f safe{hit.barycentric.x + change.x, hit.barycentric.y + change.y};
  Ray aimed = ray;
  aimed.direction += (triangle->edge1 * change.x + triangle->edge2 * change.y) / hit.distance;
  Hit found;
  world.accel->intersect({&aimed, 1}, {&found, 1});
  if (found.object != kNoHit && (found.object != hit.object || found.primitive != hit.primitive)) {
    hit = found;
    return;
  }
  if (is_parted(world, *triangle, point_on(*triangle, safe), point_on(*triangle, hit.barycentric), ray.time))
    hit.barycentric = safe;
}

}  // namespace

void nearest_hits(const World& world, std::span<const Ray> rays, std::span<Hit> hits, Coherence coherence) {
  world.accel->intersect(rays, hits, coherence);
  for (std::size_t i = 0; i < rays.size(); ++i)
    if (may_be_beside_an_edge(hits[i])) settle(world, rays[i], hits[i]);
}

}  // namespace orbs::tracer

#include "tracer/world/nearest_hits.h"

#include "tracer/world/edge_distance.h"
#include "tracer/world/surface.h"

#include <algorithm>

namespace orbs::tracer {

namespace {

bool may_be_beside_an_edge(const Hit& hit) {
  const auto& [u, v] = hit.barycentric;
  return hit.object != kNoHit && std::min({u, v, 1 - u - v}) < kMostOfHeight;
}

}  // namespace

void nearest_hits(const World& world, std::span<const Ray> rays, std::span<Hit> hits, Coherence coherence) {
  world.accel->intersect(rays, hits, coherence);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (!may_be_beside_an_edge(hits[i]) || !(hits[i].distance > 0)) continue;
    const Vec3f moved = distance_from_edges(world, hits[i]);
    if (moved == Vec3f{}) continue;
    Ray aimed = rays[i];
    aimed.direction += moved / hits[i].distance;
    Hit found;
    world.accel->intersect({&aimed, 1}, {&found, 1});
    if (found.object != kNoHit) hits[i] = found;
  }
}

}  // namespace orbs::tracer

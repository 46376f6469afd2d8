// Rays within a closed room of ridges and clefts, aimed at its edges: they never see it from outside.
#include "tracer/world/nearest_hits.h"

#include "base/random.h"
#include "scene/load/load_scene.h"
#include "tracer/world/build_world.h"
#include "tracer/world/surface.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

using namespace orbs;
using namespace orbs::tracer;

namespace {

constexpr std::size_t kRays = 400000;

Vec3f inside_the_room(std::uint64_t at) {
  const double z = 2 * unit_random(mix(at, 1)) - 1;
  const double turn = 2 * std::numbers::pi * unit_random(mix(at, 2));
  const double radius = 0.6 * std::sqrt(1 - z * z);
  return cast<float>(Vec3d{radius * std::cos(turn), radius * std::sin(turn), 0.6 * z});
}

// From places in the room to places on the edges of its triangles.
std::vector<Ray> rays_to_edges(const TriangleMesh& mesh) {
  std::vector<Ray> rays(kRays);
  for (std::uint64_t i = 0; i < kRays; ++i) {
    const auto& corners = mesh.triangles[mix(i, 3) % mesh.triangles.size()];
    const auto first = mix(i, 4) % 3;
    const Vec3f a = mesh.positions[corners[first]];
    const Vec3f b = mesh.positions[corners[(first + 1) % 3]];
    const auto share = static_cast<float>(unit_random(mix(i, 5)));
    rays[i].origin = inside_the_room(i);
    rays[i].direction = normalised(a + (b - a) * share - rays[i].origin);
  }
  return rays;
}

// Which of the hits are misses, or lie on a triangle that faces the ray with its outside.
std::size_t seen_from_outside(const World& world,
                              const std::vector<Ray>& rays,
                              const std::vector<Hit>& hits) {
  const auto& mesh = world.meshes.front();
  std::size_t count = 0;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (hits[i].object == kNoHit) {
      ++count;
      continue;
    }
    const auto& triangle = mesh.triangle_cache[hits[i].primitive];
    // The room holds the origin and is seen from there as a whole.
    const float outwards = dot(triangle.geometric_normal, triangle.corner);
    if (dot(triangle.geometric_normal, rays[i].direction) * outwards < 0) ++count;
  }
  return count;
}

}  // namespace

// What is left are triangles that the ray meets edge-on, to a third of a degree, where the plane itself is
// rounding: 13 of 2549.
TEST(NearestHits, OfAClosedRoomAreOnItsInside) {
  const auto world = make_world(
      scene::load_scene(ORBS_SOURCE_DIR "/data/cases/stability/leaks/dark-bumpy-room.json", {}, {}), {});
  const auto rays = rays_to_edges(world.meshes.front());
  std::vector<Hit> hits(rays.size());
  world.accel->intersect(rays, hits);
  const auto before = seen_from_outside(world, rays, hits);
  EXPECT_GT(before, kRays / 1000) << "else there is nothing to be done";
  nearest_hits(world, rays, hits);
  EXPECT_LT(seen_from_outside(world, rays, hits), before / 100);
}

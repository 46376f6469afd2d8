// Rays that are traversed as neighbours hit what they hit one by one, whether they are alike or not.
#include "base/nth.h"
#include "tracer/sampling/sampler.h"
#include "unit/tracer/scenes.h"

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace {

using namespace orbs;

// A tessellated ball, a ball by its formula and a floor, seen from close by.
tracer::World ball_on_floor() {
  const auto text =
      tests::scene_text("[3, 2, 4]", "[0, 0, 0]", 32, 1,
                        R"("materials": [{"name": "m", "type": "lambert", "reflectance": [1, 1, 1]}],
         "meshes": [{"name": "s", "generator": "sphere", "radius": 1, "segments": 64, "material": "m"},
                    {"name": "p", "generator": "plane", "half_size": 50, "material": "m"}],
         "instances": [{"mesh": "s"}, {"mesh": "p", "matrix": [{"translate": [0, -1, 0]}]}],
         "lights": [{"type": "sphere", "radius": 0.3, "radiance": [1, 1, 1],
                     "matrix": [{"translate": [0.5, 1.2, 1]}]}])",
                        "50");
  return tracer::make_world(scene::load_scene_text("test.json", text, ORBS_SOURCE_DIR));
}

std::vector<tracer::Ray> camera_rays(const tracer::World& world) {
  std::vector<tracer::Ray> rays;
  for (std::uint32_t pixel = 0; pixel < 1024; ++pixel) {
    const auto u = tracer::independent_point(7, pixel);
    const auto x = static_cast<float>(pixel % 32);
    const auto y = static_cast<float>(pixel / 32);
    rays.push_back(tracer::camera_ray(world.camera, x + u[0], y + u[1]));
  }
  return rays;
}

// From places about the balls, in all directions.
std::vector<tracer::Ray> scattered_rays() {
  std::vector<tracer::Ray> rays;
  for (std::uint32_t i = 0; i < 1000; ++i) {  // so that the last packet is not full
    const auto from = tracer::independent_point(8, i);
    const auto to = tracer::independent_point(9, i);
    const Vec3f direction = Vec3f{to[0], to[1], to[2]} - Vec3f{0.5F, 0.5F, 0.5F};
    rays.push_back({Vec3f{from[0], from[1], from[2]} * 4, normalised(direction)});
  }
  return rays;
}

void expect_same_hits(const tracer::World& world, const std::vector<tracer::Ray>& rays) {
  std::vector<tracer::Hit> alone(rays.size());
  std::vector<tracer::Hit> together(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i)
    world.accel->intersect({&rays[i], 1}, {&alone[i], 1}, tracer::Coherence::None);
  world.accel->intersect(rays, together, tracer::Coherence::Neighbours);
  int hits = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    ASSERT_EQ(together[i].object, alone[i].object) << i;
    if (alone[i].object == tracer::kNoHit) continue;
    ++hits;
    EXPECT_NEAR(together[i].distance, alone[i].distance, 1e-6F * alone[i].distance) << i;
  }
  EXPECT_GT(hits, 300);
}

}  // namespace

TEST(CoherentRays, CameraRaysHitWhatTheyHitAlone) {
  const auto world = ball_on_floor();
  expect_same_hits(world, camera_rays(world));
}

TEST(CoherentRays, SoDoRaysInAllDirections) {
  const auto world = ball_on_floor();
  expect_same_hits(world, scattered_rays());
}

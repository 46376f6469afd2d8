// A closed room stays dark while a lamp shines on it from outside, whatever its vertex normals are.
#include "tracer/world/build_world.h"
#include "unit/tracer/scenes.h"

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using tests::scene_text;

image::Image room(int segments, bool connects) {
  const auto text = scene_text("[0, 0.2, 0.1]", "[0, 0, -1]", 16, 12,
                               fmt::format(R"(
    "materials": [{{"name": "wall", "type": "lambert", "reflectance": [0.8, 0.8, 0.8]}}],
    "meshes": [{{"name": "room", "generator": "sphere", "radius": 2, "segments": {}, "material": "wall"}}],
    "instances": [{{"mesh": "room"}}],
    "lights": [{{"type": "rect", "half_width": 3, "half_length": 3, "radiance": [9, 9, 9],
                "matrix": [{{"translate": [0, 3, 0]}}]}}])",
                                           segments),
                               "60");
  auto world = tracer::make_world(scene::load_scene_text("test.json", text, ORBS_SOURCE_DIR));
  world.connects_light_vertices = connects;
  const std::atomic<bool> never{false};
  return tracer::render(world, {.samples_per_pixel = 64}, never, [](const tracer::Progress&) {}).image;
}

}  // namespace

TEST(TracerLeaks, ASmoothClosedRoomIsExactlyBlack) {
  for (const int segments : {8, 16, 32, 64})
    for (const bool connects : {false, true})
      EXPECT_EQ(tests::mean_of_channel(room(segments, connects), 0), 0) << segments << " segments";
}

// A ball on a ground whose size must not matter: what is left of an even sky beside it is known.
#include "unit/tracer/scenes.h"

#include <array>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace {

using namespace orbs;

// Of points and directions, as a turn of the whole world.
struct Turn {
  std::array<Vec3d, 3> rows{Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}};
  Vec3d operator()(Vec3d p) const { return {dot(rows[0], p), dot(rows[1], p), dot(rows[2], p)}; }
};

Turn oblique() {
  const Vec3d x = normalised(Vec3d{0.8, 0.3, -0.2});
  const Vec3d y = normalised(cross(Vec3d{0.1, 0.2, 0.9}, x));
  return {{x, y, cross(x, y)}};
}

std::string text_of(Vec3d p) { return fmt::format("[{:.17g}, {:.17g}, {:.17g}]", p.x, p.y, p.z); }

// The matrix that moves by (0, y, 0) and then turns.
std::string matrix_of(const Turn& turn, double y) {
  std::string numbers;
  for (const Vec3d row : turn.rows)
    numbers += fmt::format("{:.17g}, {:.17g}, {:.17g}, {:.17g}, ", row.x, row.y, row.z, row.y * y);
  return "[" + numbers + "0, 0, 0, 1]";
}

// A black ball of radius 1 takes cos = (1 + x^2)^(-3/2) of the irradiance of an even sky at the distance x
// from the point where it rests. `ground` is an entry of "shapes" or what goes before them, its top at y = 0
// before the turn.
void expect_occlusion_on(const std::string& ground, const Turn& turn, const std::string& name) {
  constexpr double kDistance = 2;
  const double expected = 0.5 * (1 - std::pow(1 + kDistance * kDistance, -1.5));
  const std::string ball = fmt::format(
      R"({{"type": "sphere", "centre": {}, "radius": 1, "material": "black"}})", text_of(turn({0, 1, 0})));
  const bool is_shape = ground.starts_with("{");
  const std::string content = fmt::format(
      R"("environment": [1, 1, 1], "materials": [{{"name": "white", "type": "lambert", "reflectance": [0.5, 0.5, 0.5]}},
      {{"name": "black", "type": "lambert", "reflectance": [0, 0, 0]}}], {}"shapes": [{}{}])",
      is_shape ? "" : ground + ", ", ball, is_shape ? ", " + ground : "");
  const auto image = tests::render_text(tests::scene_text(text_of(turn({kDistance + 0.6, 0.9, 2})),
                                                          text_of(turn({kDistance, 0, 0})), 8, 1, content),
                                        {.samples_per_pixel = 512})
                         .image;
  EXPECT_NEAR(tests::mean_of_channel(image, 0), expected,
              4 * tests::error_of_mean(image, 0) + 1e-3 * expected)
      << name;
}

}  // namespace

// The offset of rays that leave a ball grew with the ball: on one of 1000 km the floor beside it was 6 %
// too bright, and on one of 10,000 km the ball had no shadow.
TEST(VastGrounds, OfBalls) {
  for (const double radius : {1e4, 1e5, 1e6, 1e7, 1e8}) {
    expect_occlusion_on(fmt::format(R"({{"type": "sphere", "centre": [0, {0}, 0], "radius": {1},
                                        "material": "white"}})",
                                    -radius, radius),
                        {}, fmt::format("ball of {} m", radius));
    expect_occlusion_on(fmt::format(R"({{"type": "sphere", "centre": [0, 0, 0], "radius": 1,
                                        "material": "white",
                                        "matrix": [{{"translate": [0, {0}, 0]}}, {{"scale": {1}}}]}})",
                                    -radius, radius),
                        {}, fmt::format("ellipsoid of {} m", radius));
  }
}

TEST(VastGrounds, OfBoxesThatAreTurned) {
  for (const double size : {1e4, 1e6, 1e8, 1e9})
    for (const Turn& turn : {Turn{}, oblique()})
      expect_occlusion_on(fmt::format(R"({{"type": "box", "half_sizes": [{0}, {0}, {0}], "material": "white",
                                          "matrix": {1}}})",
                                      size, matrix_of(turn, -size)),
                          turn, fmt::format("box of {} m", size));
}

// Triangles that lie askew had corners that were rounded by as much as the ball is large.
TEST(VastGrounds, OfTrianglesThatAreTurned) {
  for (const double size : {1e4, 1e6, 1e8, 1e9})
    for (const Turn& turn : {Turn{}, oblique()})
      expect_occlusion_on(
          fmt::format(
              R"("meshes": [{{"name": "ground", "generator": "plane", "half_size": {}, "material": "white"}}],
                 "instances": [{{"mesh": "ground", "matrix": {}}}])",
              size, matrix_of(turn, 0)),
          turn, fmt::format("triangles of {} m", size));
}

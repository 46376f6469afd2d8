// Guides of light paths: where they send paths, and that the density they state is the one they have.
#include "tracer/light/light_guides.h"

#include "property/hashed_numbers.h"
#include "tracer/integrator/light_emission.h"
#include "unit/tracer/scenes.h"

#include <numbers>
#include <numeric>

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using namespace orbs::tracer;

// Two regions in which trial paths of emitters 0 and 3 were of use, and some that were of none.
std::vector<GuideTrial> trials() {
  std::vector<GuideTrial> out;
  for (int i = 0; i < 20; ++i) {
    const auto t = static_cast<float>(i) / 20;
    out.push_back({0, {t, 0, 0}, 3});
    out.push_back({3, {5, t, 0}, 1});
    out.push_back({1, {0, 9, 0}, 0});
  }
  return out;
}

World three_emitters() {
  return make_world(scene::load_scene_text("test.json", tests::scene_text("[0, 1, 5]", "[0, 0, 0]", 8, 2, R"(
    "materials": [{"name": "floor", "type": "lambert", "reflectance": [0.5, 0.5, 0.5]},
                  {"name": "glow", "type": "emission", "radiance": [2, 2, 2]}],
    "meshes": [{"name": "p", "generator": "plane", "half_size": 4, "material": "floor"},
               {"name": "card", "generator": "plane", "half_size": 0.5, "material": "glow"}],
    "instances": [{"mesh": "p"}, {"mesh": "card", "matrix": [{"translate": [2, 1, 0]}, {"rotate_z": 50}]}],
    "lights": [{"type": "rect", "half_width": 0.5, "half_length": 0.25, "radiance": [9, 9, 9],
                "matrix": [{"translate": [0, 1, 0]}]},
               {"type": "sphere", "radius": 0.3, "radiance": [1, 1, 1], "matrix": [{"translate": [-2, 1, 0]}]}])"),
                                           ORBS_SOURCE_DIR));
}

// A small target for each emitter, one that overlaps it, and one around an emitter.
std::vector<LightGuide> guides_of(const World& world) {
  std::vector<LightGuide> out;
  for (std::size_t i = 0; i < world.emitters.size(); ++i) out.push_back({i, {{1, 0, 1}, 0.4F}, 0.1F});
  out.push_back({0, {{0.8F, 0, 1}, 0.4F}, 0.2F});
  out.push_back({1, {{-2, 1, 0}, 1}, 0.15F});
  return out;
}

}  // namespace

TEST(LightGuides, LieWherePathsWereOfUse) {
  const auto guides = make_light_guides(trials());
  ASSERT_FALSE(guides.empty());
  double sum = 0;
  double of_first = 0;
  for (const LightGuide& guide : guides) {
    EXPECT_TRUE(guide.emitter == 0 || guide.emitter == 3);
    sum += static_cast<double>(guide.probability);
    if (guide.emitter == 0) of_first += static_cast<double>(guide.probability);
  }
  EXPECT_NEAR(sum, 1 - static_cast<double>(kUnguidedShare), 1e-5);
  EXPECT_NEAR(of_first, 0.75 * sum, 1e-5);
  for (const GuideTrial& trial : trials()) {
    const bool is_inside = std::any_of(guides.begin(), guides.end(), [&](const LightGuide& guide) {
      return guide.emitter == trial.emitter &&
             length(trial.position - guide.target.centre) <= guide.target.radius;
    });
    EXPECT_EQ(is_inside, trial.use > 0);
  }
}

TEST(LightGuides, NeedSomeTrialsOfUse) {
  const std::vector<GuideTrial> few{{0, {}, 1}, {0, {1, 0, 0}, 1}, {0, {0, 1, 0}, 1}, {0, {0, 0, 1}, 0}};
  EXPECT_TRUE(make_light_guides(few).empty());
  EXPECT_TRUE(make_light_guides({}).empty());
}

TEST(LightGuides, ArePickedByTheirProbability) {
  const std::vector<LightGuide> guides{{0, {}, 0.25F}, {1, {}, 0.5F}};
  EXPECT_EQ(pick_guide(guides, 0.2F), &guides[0]);
  EXPECT_EQ(pick_guide(guides, 0.5F), &guides[1]);
  EXPECT_EQ(pick_guide(guides, 0.76F), nullptr);
  EXPECT_EQ(pick_guide({}, 0), nullptr);
}

// Cosine over density has the mean pi times the area of all bright sides, which each path can leave, and the
// density that MIS asks for is that of the path.
TEST(LightGuides, StateTheDensityOfTheirPaths) {
  for (const bool is_guided : {false, true}) {
    World world = three_emitters();
    if (is_guided) world.light_guides = guides_of(world);
    double sum = 0;
    constexpr std::uint64_t kPaths = 400'000;
    for (std::uint64_t i = 0; i < kPaths; ++i) {
      const auto ray = emit_towards_use(world, tests::four_uniform(2 * i), tests::four_uniform(2 * i + 1));
      if (!(ray.weight > 0)) continue;
      sum += static_cast<double>(ray.weight);
      if (i % 16 != 0) continue;
      const float pdf = emission_pdf(world, ray.emitter, ray.position, ray.position + ray.ray.direction);
      EXPECT_NEAR(static_cast<double>(pdf * ray.weight / kPi), 1, 0.01) << is_guided << " " << i;
    }
    const double area = 1 * 0.5 + 4 * std::numbers::pi * 0.09 + 2 * 1;
    EXPECT_NEAR(sum / kPaths / (std::numbers::pi * area), 1, 0.01) << is_guided;
  }
}

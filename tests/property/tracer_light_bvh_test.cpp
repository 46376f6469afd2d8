// The light BVH: what it selects, with which probability, and that no light is ever left out.
#include "property/hashed_numbers.h"
#include "property/sampling_density.h"
#include "tracer/light/emitter.h"
#include "tracer/light/light_bvh.h"
#include "tracer/sampling/warps.h"

#include <cmath>

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using namespace orbs::tracer;
using tests::uniform;

Vec3f point_in_cube(std::uint64_t i, float half) {
  return {half * (2 * uniform(i, 0) - 1), half * (2 * uniform(i, 1) - 1), half * (2 * uniform(i, 2) - 1)};
}

Vec3f direction(std::uint64_t i) { return normalised(point_in_cube(i, 1)); }

struct Emitters {
  std::vector<AreaLight> lights;
  std::vector<TriangleEmitter> triangles;
  std::vector<float> powers;
};

AreaLight light_of(const EmitterShape& shape) {
  AreaLight light;
  light.shape = shape;
  light.radiance = {{1, 1, 1}, -1};
  return light;
}

// Rectangles that face all ways, balls, and triangles, in a cube of 4 m.
Emitters many_emitters() {
  Emitters out;
  for (std::uint64_t i = 0; i < 12; ++i) {
    const Vec3f normal = direction(100 + i);
    const Vec3f a = normalised(cross(normal, direction(200 + i))) * 0.3F;
    const Vec3f b = cross(normal, a);
    out.lights.push_back(light_of(RectEmitter{cast<double>(point_in_cube(300 + i, 2)), cast<double>(a),
                                              cast<double>(b), cast<double>(normal), 0.36F, true}));
  }
  for (std::uint64_t i = 0; i < 3; ++i) {
    SphereEmitter ball;
    ball.centre = cast<double>(point_in_cube(400 + i, 2));
    ball.axes = {Vec3d{0.2, 0, 0}, Vec3d{0, 0.2, 0}, Vec3d{0, 0, 0.2}};
    ball.inverse = {Vec3d{5, 0, 0}, Vec3d{0, 5, 0}, Vec3d{0, 0, 5}};
    ball.determinant = 0.008;
    out.lights.push_back(light_of(ball));
  }
  for (std::uint64_t i = 0; i < 20; ++i) {
    const Vec3f edge1 = direction(500 + i) * 0.4F;
    const Vec3f edge2 = direction(600 + i) * 0.4F;
    const Vec3f normal = cross(edge1, edge2);
    out.triangles.push_back(
        {point_in_cube(700 + i, 2), edge1, edge2, normalised(normal), 0.5F * length(normal), {}, 0});
  }
  for (std::size_t i = 0; i < out.lights.size() + out.triangles.size(); ++i)
    out.powers.push_back(0.1F + uniform(i, 9));
  return out;
}

// The last seven triangles are one object.
LightBvh bvh_of(const Emitters& e) {
  constexpr std::size_t kTogether = 7;
  const std::size_t alone = e.powers.size() > kTogether ? e.powers.size() - kTogether : e.powers.size();
  std::vector<EmitterGroup> groups;
  for (std::size_t i = 0; i < alone; ++i) groups.push_back({i, 1});
  if (alone < e.powers.size()) groups.push_back({alone, kTogether});
  return LightBvh(bounds_of(e.lights, e.triangles, e.powers), groups);
}

// Whether a point of the emitter, sampled from the context, is on the side of its normal.
bool shines_on(const Emitters& e, std::size_t emitter, const LightSampleContext& at, float u, float v) {
  Vec2f uv;
  const auto point = emitter < e.lights.size()
                         ? sample_towards(e.lights[emitter].shape, at.position, u, v)
                         : sample_towards(e.triangles[emitter - e.lights.size()], at.position, {u, v}, uv);
  if (!point) return false;
  return at.normal == Vec3f{} || dot(at.normal, point->position - at.position) > 1e-4F;
}

}  // namespace

TEST(LightBvh, SelectsWithTheProbabilityThatItStates) {
  const Emitters e = many_emitters();
  const LightBvh bvh = bvh_of(e);
  constexpr int kSteps = 100000;
  for (std::uint64_t i = 0; i < 6; ++i) {
    const Vec3f position = point_in_cube(i, 3);
    const LightSampleContext at{position,
                                i % 2 == 0 ? normalised(-position) : Vec3f{}};  // towards the middle
    std::vector<int> counts(e.powers.size());
    for (int k = 0; k < kSteps; ++k) {
      const auto selected = bvh.select(at, (static_cast<float>(k) + 0.5F) / kSteps);
      ASSERT_TRUE(selected.has_value());
      ++counts[selected->emitter];
      EXPECT_NEAR(selected->probability, bvh.probability(at, selected->emitter), 1e-5F);
    }
    double sum = 0;
    for (std::size_t k = 0; k < counts.size(); ++k) {
      const double probability = bvh.probability(at, k);
      sum += probability;
      EXPECT_NEAR(counts[k], probability * kSteps, 3) << k;
    }
    EXPECT_NEAR(sum, 1, 1e-5);
  }
}

TEST(LightBvh, NeverLeavesOutAnEmitterThatShinesOnThePoint) {
  const Emitters e = many_emitters();
  const LightBvh bvh = bvh_of(e);
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const LightSampleContext at{point_in_cube(i, 2.5F), direction(5000 + i)};
    for (std::size_t k = 0; k < e.powers.size(); ++k) {
      if (!shines_on(e, k, at, uniform(i, 3), uniform(i, 4))) continue;
      EXPECT_GT(bvh.probability(at, k), 0) << "point " << i << ", emitter " << k;
    }
  }
}

TEST(LightBvh, LeavesOutEmittersBehindThePointOrTurnedAway) {
  Emitters e;
  const Vec3d a{0.1, 0, 0};
  const Vec3d b{0, 0, 0.1};
  e.lights = {light_of(RectEmitter{{0, 2, 0}, a, b, {0, -1, 0}, 0.04F, true}),   // above, shines down
              light_of(RectEmitter{{0, 2, 0}, a, b, {0, 1, 0}, 0.04F, true}),    // above, shines up
              light_of(RectEmitter{{0, -2, 0}, a, b, {0, 1, 0}, 0.04F, true})};  // below, shines up
  e.powers = {1, 100, 100};
  const LightBvh bvh = bvh_of(e);
  const LightSampleContext floor{{0, 0, 0}, {0, 1, 0}};
  EXPECT_FLOAT_EQ(bvh.probability(floor, 0), 1);
  EXPECT_EQ(bvh.probability(floor, 1), 0);
  EXPECT_EQ(bvh.probability(floor, 2), 0);
  const LightSampleContext glass{{0, 0, 0}, {}};
  EXPECT_GT(bvh.probability(glass, 2), 0);
  const LightSampleContext top{{0, 3, 0}, {0, 1, 0}};
  EXPECT_FALSE(bvh.select(top, 0.5F).has_value());
}

TEST(LightBvh, LeavesOutAWideEmitterThatLiesBeyondAHorizon) {
  // The underside of a slab: a lamp as wide as the room is above it, a small one below. From within the
  // sphere about the wide lamp no direction to it is known.
  Emitters e;
  e.lights = {light_of(RectEmitter{{0, 6, 0}, {5, 0, 0}, {0, 0, 5}, {0, -1, 0}, 100, true}),
              light_of(RectEmitter{{0, 0.6F, 0}, {0.5F, 0, 0}, {0, 0, 0.5F}, {0, 1, 0}, 1, true})};
  e.powers = {100, 1};
  const LightBvh bvh = bvh_of(e);
  const LightSampleContext underside{{1, 2, 1}, {0, -1, 0}};
  EXPECT_EQ(bvh.probability(underside, 0), 0);
  EXPECT_FLOAT_EQ(bvh.probability(underside, 1), 1);
  const LightSampleContext glass_above_the_lamp{{1, 6.5F, 1}, {}};
  EXPECT_EQ(bvh.probability(glass_above_the_lamp, 0), 0);
}

TEST(LightBvh, EmittersWithoutPowerAreNeverSelected) {
  Emitters e = many_emitters();
  e.powers[3] = 0;
  const LightBvh bvh = bvh_of(e);
  EXPECT_EQ(bvh.probability({{0, 0, 0}, {}}, 3), 0);
}

namespace {

// Trials at points of the cube, of which those with a positive x see nothing of the emitters with an odd
// number.
LightBvh learned_bvh(const Emitters& e) {
  LightBvh bvh = bvh_of(e);
  std::vector<LightTrial> trials;
  for (std::uint64_t i = 0; i < 20000; ++i) {
    const LightSampleContext at{point_in_cube(9000 + i, 2.5F), direction(40000 + i)};
    const auto selected = bvh.select(at, uniform(i, 7));
    if (!selected) continue;
    const bool is_blocked = at.position.x > 0 && selected->emitter % 2 == 1;
    trials.push_back({at, selected->emitter, is_blocked ? 0 : uniform(i, 8)});
  }
  bvh.learn(trials, {.eye = {0, 0, 5}});
  return bvh;
}

}  // namespace

TEST(LearnedLightBvh, SelectsWithTheProbabilityThatItStatesAndLeavesOutNoEmitter) {
  const Emitters e = many_emitters();
  const LightBvh bvh = learned_bvh(e);
  ASSERT_TRUE(bvh.has_learned());
  ASSERT_GT(bvh.factors().row_count(), 100U);
  for (std::uint64_t i = 0; i < 3000; ++i) {
    const LightSampleContext at{point_in_cube(i, 2.5F), direction(5000 + i)};
    // A node whose children cannot shine on the point may be selected nevertheless: then there is no sample.
    constexpr int kSteps = 400;
    int selections = 0;
    for (int k = 0; k < kSteps; ++k) {
      const auto selected = bvh.select(at, (static_cast<float>(k) + 0.5F) / kSteps);
      if (!selected) continue;
      ++selections;
      EXPECT_NEAR(selected->probability, bvh.probability(at, selected->emitter), 1e-5F);
    }
    double sum = 0;
    for (std::size_t k = 0; k < e.powers.size(); ++k) {
      const double probability = bvh.probability(at, k);
      sum += probability;
      if (shines_on(e, k, at, uniform(i, 3), uniform(i, 4))) {
        EXPECT_GT(probability, 0) << "point " << i << ", emitter " << k;
      }
    }
    EXPECT_NEAR(sum, static_cast<double>(selections) / kSteps, 0.05) << "point " << i;
  }
}

// Where no emitter can shine on the point, none is selected: the rest of the probabilities.
TEST(LearnedLightBvh, PicksWithTheProbabilityThatItStates) {
  const Emitters e = many_emitters();
  for (const LightBvh& bvh : {bvh_of(e), learned_bvh(e)})
    for (std::uint64_t point = 0; point < 20; ++point) {
      const Vec3f normal = point % 3 == 0 ? Vec3f{} : direction(5000 + point);
      const LightSampleContext at{point_in_cube(point, 2.5F), normal};
      std::vector<std::size_t> counts(e.powers.size(), 0);
      for (std::uint64_t i = 0; i < tests::kTrials; ++i)
        if (const auto selected = bvh.select(at, with_more_digits(uniform(i, 21), uniform(i, 22))))
          ++counts[selected->emitter];
      std::vector<double> probabilities;
      for (std::size_t k = 0; k < e.powers.size(); ++k) probabilities.push_back(bvh.probability(at, k));
      tests::expect_density(tests::chi_square_of_counts(counts, probabilities, tests::kTrials),
                            "point " + std::to_string(point) + (bvh.has_learned() ? ", learned" : ""));
    }
}

TEST(LearnedLightBvh, SelectsLessOftenWhatWasBlocked) {
  const Emitters e = many_emitters();
  const LightBvh before = bvh_of(e);
  const LightBvh after = learned_bvh(e);
  double blocked_before = 0;
  double blocked_after = 0;
  for (std::uint64_t i = 0; i < 500; ++i) {
    LightSampleContext at{point_in_cube(i, 2.5F), direction(5000 + i)};
    at.position.x = std::abs(at.position.x) + 0.1F;
    for (std::size_t k = 1; k < e.lights.size(); k += 2) {
      blocked_before += before.probability(at, k);
      blocked_after += after.probability(at, k);
    }
  }
  EXPECT_LT(blocked_after, 0.7 * blocked_before);
}

// Light sampling: the pdf of a sample equals the pdf at its point, and the mean of 1 / pdf is the solid
// angle.
#include "property/hashed_numbers.h"
#include "property/sampling_density.h"
#include "tracer/light/emitter.h"
#include "tracer/light/emitter_table.h"
#include "tracer/sampling/warps.h"

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using namespace orbs::tracer;
using tests::uniform;

RectEmitter rect(Vec3f centre, Vec3f a, Vec3f b, bool orthogonal) {
  return {cast<double>(centre), cast<double>(a),         cast<double>(b),
          {0, -1, 0},           4 * length(cross(a, b)), orthogonal};
}

SphereEmitter ball(Vec3f centre, Vec3f radii) {
  const Vec3d r = cast<double>(radii);
  SphereEmitter s;
  s.centre = cast<double>(centre);
  s.axes = {Vec3d{r.x, 0, 0}, Vec3d{0, r.y, 0}, Vec3d{0, 0, r.z}};
  s.inverse = {Vec3d{1 / r.x, 0, 0}, Vec3d{0, 1 / r.y, 0}, Vec3d{0, 0, 1 / r.z}};
  s.determinant = r.x * r.y * r.z;
  return s;
}

// Fraction of the sphere of directions that hits the shape, by the mean of 1 / pdf.
double solid_angle(const EmitterShape& shape, Vec3f from) {
  constexpr int kSide = 300;
  double sum = 0;
  for (int i = 0; i < kSide; ++i)
    for (int j = 0; j < kSide; ++j)
      if (const auto p = sample_towards(shape, from, (static_cast<float>(i) + 0.5F) / kSide,
                                        (static_cast<float>(j) + 0.5F) / kSide))
        sum += 1 / p->pdf;
  return sum / (kSide * kSide);
}

// Rectangle a x b at distance d over its centre: 4 asin(ab / sqrt((a^2+4d^2)(b^2+4d^2))).
double centred_rectangle(double a, double b, double d) {
  return 4 * std::asin(a * b / std::sqrt((a * a + 4 * d * d) * (b * b + 4 * d * d)));
}

}  // namespace

TEST(Emitter, SamplesCarryTheDensityOfTheirPoint) {
  const std::vector<EmitterShape> shapes{
      rect({0, 2, 0}, {0.5F, 0, 0}, {0, 0, 1}, true), rect({0, 2, 0}, {0.5F, 0, 0.2F}, {0, 0, 1}, false),
      DiskEmitter{{0, 2, 0}, {1, 0, 0}, {0, 0, 0.5F}, {0, -1, 0}, 0.5F * 3.14159265F},
      ball({0, 2, 0}, {0.5F, 0.5F, 0.5F}), ball({0, 2, 0}, {0.5F, 0.25F, 1})};
  for (const auto& shape : shapes)
    for (const Vec3f from :
         {Vec3f{0, 0, 0}, Vec3f{0.3F, 1.2F, 0.1F}, Vec3f{10, -3, 4}, Vec3f{0.2F, 0.7F, -0.9F}})
      for (std::uint64_t i = 0; i < 200; ++i) {
        const auto point = sample_towards(shape, from, uniform(i, 0), uniform(i, 1));
        ASSERT_TRUE(point.has_value()) << shape.index();
        EXPECT_NEAR(pdf_towards(shape, from, point->position), point->pdf, 2e-3F * point->pdf)
            << shape.index();
        EXPECT_GT(dot(point->normal, from - point->position), 0) << shape.index();
      }
}

TEST(Emitter, ARectangleHasItsSolidAngleNearAndFar) {
  const EmitterShape shape = rect({0, 0, 0}, {0.5F, 0, 0}, {0, 0, 1}, true);
  for (const float d : {0.01F, 0.1F, 0.5F, 1.0F, 2.0F, 5.0F, 50.0F})
    EXPECT_NEAR(solid_angle(shape, {0, -d, 0}), centred_rectangle(1, 2, d), 2e-3 * centred_rectangle(1, 2, d))
        << d;
}

TEST(Emitter, ABallHasItsSolidAngleNearAndFar) {
  for (const float d : {1.001F, 1.5F, 10.0F, 1000.0F}) {
    const double sin2 = 1.0 / (double{d} * d);
    const double expected = 2 * std::numbers::pi * sin2 / (1 + std::sqrt(1 - sin2));
    EXPECT_NEAR(solid_angle(ball({0, 0, 0}, {1, 1, 1}), {0, d, 0}), expected, 1e-3 * expected) << d;
  }
}

// Axis of a spheroid: tangent cone with sin^2 = a^2 / (a^2 + h^2 - c^2).
TEST(Emitter, ASpheroidHasTheSolidAngleOfItsTangentCone) {
  const double sin2 = 0.25 / (0.25 + 9 - 4);
  const double expected = 2 * std::numbers::pi * sin2 / (1 + std::sqrt(1 - sin2));
  EXPECT_NEAR(solid_angle(ball({0, 0, 0}, {0.5F, 2, 0.5F}), {0, 3, 0}), expected, 2e-3 * expected);
}

// Of 2^24 equal steps the first would be sixty times as wide as the share of the second emitter.
TEST(EmitterTable, PicksWhatIsNextToImprobableNoMoreOftenThanItSays) {
  EmitterTable table;
  table.build({1, 1e-9F}, {}, 2);
  const double share = table.probability(1);
  constexpr double kItsSlot = 0.5;  // begins here and holds it first
  EXPECT_EQ(table.pick(kItsSlot + 0.9 * share), 1U);
  EXPECT_EQ(table.pick(kItsSlot + 1.1 * share), 0U);
  EXPECT_EQ(with_more_digits(0.5F, 0.25F), 0.5 + 0x1p-26);
  EXPECT_LT(with_more_digits(0x1.fffffep-1F, 1), 1);
}

// Few and many emitters, of like powers and of powers over six orders of magnitude.
TEST(EmitterTable, PicksWithTheProbabilityThatItStates) {
  for (const std::size_t size : {2U, 3U, 17U, 1000U})
    for (const float orders : {0.0F, 1.0F, 6.0F}) {
      std::vector<float> powers;
      for (std::uint64_t i = 0; i < size; ++i) powers.push_back(std::pow(10.0F, orders * uniform(i, 20)));
      EmitterTable table;
      table.build(powers, {}, size);
      std::vector<std::size_t> counts(size, 0);
      for (std::uint64_t i = 0; i < 10 * tests::kTrials; ++i)
        ++counts[table.pick(with_more_digits(uniform(i, 21), uniform(i, 22)))];
      std::vector<double> probabilities;
      for (std::size_t i = 0; i < size; ++i) probabilities.push_back(table.probability(i));
      tests::expect_density(tests::chi_square_of_counts(counts, probabilities, 10 * tests::kTrials),
                            std::to_string(size) + " emitters over " + std::to_string(orders) + " orders");
    }
}

// The test itself can fail: one pick in fifty goes to the next emitter.
TEST(EmitterTable, ChiSquareFindsWrongPicks) {
  EmitterTable table;
  table.build({1, 3, 2, 4}, {}, 4);
  std::vector<std::size_t> counts(4, 0);
  for (std::uint64_t i = 0; i < 10 * tests::kTrials; ++i)
    ++counts[(table.pick(uniform(i, 21)) + (uniform(i, 22) < 0.02F ? 1 : 0)) % 4];
  EXPECT_LT(tests::chi_square_of_counts(counts, {0.1, 0.3, 0.2, 0.4}, 10 * tests::kTrials).p_value,
            tests::kDensityLevel);
}

TEST(EmitterTable, PicksInProportionToPower) {
  EmitterTable table;
  table.build({1, 3, 0, 4}, {}, 4);
  std::array<int, 4> picked{};
  constexpr int kSteps = 80000;
  for (int i = 0; i < kSteps; ++i) ++picked[table.pick((static_cast<float>(i) + 0.5F) / kSteps)];
  EXPECT_NEAR(picked[0], kSteps / 8, 2);
  EXPECT_NEAR(picked[1], 3 * kSteps / 8, 2);
  EXPECT_EQ(picked[2], 0);
  EXPECT_NEAR(picked[3], kSteps / 2, 2);
  EXPECT_FLOAT_EQ(table.probability(1), 0.375F);
}

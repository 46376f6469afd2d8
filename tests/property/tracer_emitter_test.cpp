// Light sampling: the pdf of a sample equals the pdf at its point, and the mean of 1 / pdf is the solid
// angle.
#include "property/hashed_numbers.h"
#include "tracer/light/emitter.h"
#include "tracer/light/emitter_table.h"

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using namespace orbs::tracer;
using tests::uniform;

RectEmitter rect(Vec3f centre, Vec3f a, Vec3f b, bool orthogonal) {
  return {centre, a, b, {0, -1, 0}, 4 * length(cross(a, b)), orthogonal};
}

SphereEmitter ball(Vec3f centre, Vec3f radii) {
  SphereEmitter s;
  s.centre = centre;
  s.axes = {Vec3f{radii.x, 0, 0}, Vec3f{0, radii.y, 0}, Vec3f{0, 0, radii.z}};
  s.inverse = {Vec3f{1 / radii.x, 0, 0}, Vec3f{0, 1 / radii.y, 0}, Vec3f{0, 0, 1 / radii.z}};
  s.determinant = radii.x * radii.y * radii.z;
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

// Form factors against numbers that were found by quadrature and are in the literature.
#include "analytic/form_factor.h"

#include "base/error.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

using namespace orbs;
using analytic::Corners;

namespace {

constexpr Vec3d kUp{0, 1, 0};

double degrees(double angle) { return angle * std::numbers::pi / 180; }

Corners lamp_above(double x0, double x1, double z0, double z1, double y) {
  return {{x0, y, z0}, {x1, y, z0}, {x1, y, z1}, {x0, y, z1}};
}

}  // namespace

TEST(FormFactor, OfRectanglesIsThatOfHowellsCatalogue) {
  EXPECT_NEAR(analytic::polygon_form_factor(lamp_above(0, 1, 0, 1, 1), kUp), 0.13853161, 1e-8);
  EXPECT_NEAR(analytic::polygon_form_factor(lamp_above(-.5, .5, -.5, .5, 1), kUp), 0.23945647, 1e-8);
  // Perpendicular, its lower edge in the plane of the receiver; a = b = c.
  EXPECT_NEAR(analytic::polygon_form_factor({{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}}, kUp), 0.05573420,
              1e-8);
}

TEST(FormFactor, OfAPolygonEndsAtTheHorizon) {
  const Corners upper{{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}};
  const Corners whole{{1, -3, 0}, {1, 1, 0}, {1, 1, 1}, {1, -3, 1}};
  EXPECT_NEAR(analytic::polygon_form_factor(whole, kUp), analytic::polygon_form_factor(upper, kUp), 1e-14);
  EXPECT_EQ(analytic::polygon_form_factor(lamp_above(0, 1, 0, 1, -1), kUp), 0);
}

TEST(FormFactor, OfASphereIsClippedAtTheHorizon) {
  const auto at = [](double distance, double angle) {
    return analytic::sphere_form_factor(
        {distance * std::sin(degrees(angle)), distance * std::cos(degrees(angle)), 0}, 1, kUp);
  };
  EXPECT_NEAR(at(2, 0), 0.25, 1e-12);
  EXPECT_NEAR(at(2, 30), 0.21650635, 1e-8);
  EXPECT_NEAR(at(2, 60), 0.125, 1e-9);
  EXPECT_NEAR(at(2, 80), 0.05469582, 1e-8);
  EXPECT_NEAR(at(2, 90), 0.02883444, 1e-8);
  EXPECT_NEAR(at(2, 100), 0.01128377, 1e-8);
  EXPECT_EQ(at(2, 120), 0);
  EXPECT_NEAR(at(1.25, 60), 0.34271305, 1e-8);
  EXPECT_NEAR(at(1.25, 120), 0.02271305, 1e-8);
}

TEST(FormFactor, OfAParallelDiskHasAClosedForm) {
  EXPECT_NEAR(analytic::parallel_disk_form_factor(1, 0, 1), 0.5, 1e-12);
  EXPECT_NEAR(analytic::parallel_disk_form_factor(1, .5, 1), 0.43798263, 1e-8);
  EXPECT_NEAR(analytic::parallel_disk_form_factor(1, 2, 1), 0.05278641, 1e-8);
  EXPECT_THROW(analytic::coverage(registry::RoundDisk{{0, 1, 0}, {1, 0, 0}, 1}, {}, {}, {}, kUp), InputError);
}

// The lamp and its mirror image, which is seen through the outline of the mirror alone.
TEST(FormFactor, OfAMirroredLampIsClippedByTheMirror) {
  const Corners lamp{{-1, .2, .3}, {-1, .2, -.3}, {-1, .8, -.3}, {-1, .8, .3}};
  const Corners image{{3, .2, -.3}, {3, .2, .3}, {3, .8, .3}, {3, .8, -.3}};
  const Corners mirror{{1, 0, -.5}, {1, 0, .5}, {1, .8, .5}, {1, .8, -.5}};
  const auto at = [&](const Corners& shape, const Corners& window, double x, double z) {
    return analytic::coverage(registry::FlatPolygon{shape}, window, {}, {x, 0, z}, kUp).form_factor;
  };
  EXPECT_NEAR(at(lamp, {}, .5, 0), 0.01269062, 1e-8);
  EXPECT_NEAR(at(image, mirror, .5, 0), 0.00327537, 1e-8);
  EXPECT_NEAR(at(image, mirror, .8, .4), 0.00439386, 1e-8);
  EXPECT_NEAR(at(image, mirror, -.5, 0), 0.00125986, 1e-8);
}

TEST(FormFactor, OnlyTheFrontShows) {
  const registry::FlatPolygon down{{{-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1}}};
  EXPECT_TRUE(analytic::coverage(down, {}, {}, {}, kUp).shows_front);
  EXPECT_FALSE(analytic::coverage(down, {}, {}, {0, 2, 0}, -kUp).shows_front);
}

// A slab before half of a lamp leaves the form factor of the other half; one behind it, or beside it, all.
TEST(FormFactor, WhatIsHiddenDoesNotCount) {
  const registry::FlatPolygon lamp{lamp_above(-1, 1, -1, 1, 2)};
  const auto seen = [&](const std::vector<Corners>& blockers) {
    return analytic::coverage(lamp, {}, blockers, {}, kUp).form_factor;
  };
  const double all = seen({});
  EXPECT_NEAR(seen({lamp_above(0, 5, -5, 5, 1)}), all / 2, 1e-12);
  EXPECT_NEAR(seen({lamp_above(0, 5, -5, 5, 1), lamp_above(-5, 5, 0, 5, .5)}), all / 4, 1e-12);
  EXPECT_NEAR(seen({lamp_above(-5, 5, -5, 5, 3)}), all, 1e-15);
  EXPECT_NEAR(seen({lamp_above(2, 5, -5, 5, 1)}), all, 1e-12);
  EXPECT_NEAR(seen({lamp_above(-5, 5, -5, 5, 1)}), 0, 1e-15);
  // A wall that pierces the lamp hides what is behind its lower part.
  EXPECT_NEAR(seen({{{0, -1, -9}, {0, -1, 9}, {2, 3, 9}, {2, 3, -9}}}),
              seen({{{0.5, 0, -9}, {0.5, 0, 9}, {1.5, 2, 9}, {1.5, 2, -9}}}), 1e-9);
}

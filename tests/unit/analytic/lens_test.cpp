// Blur through a thin lens by its formula.
#include "analytic/lens.h"

#include "analytic/analytic_image.h"
#include "base/error.h"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

using namespace orbs;

namespace {

// At (0, 0, 5), in focus at z = 0: one pixel, as wide as the plane there is high.
scene::Camera camera(double radius) {
  scene::Camera made;
  made.position_m = {0, 0, 5};
  made.fov_y_deg = 2 * std::atan(0.2) * 180 / std::numbers::pi;  // 2 m at 5 m
  made.width_px = made.height_px = 2;
  made.focus_distance_m = 5;
  made.aperture_radius_m = radius;
  return made;
}

registry::AnalyticSurface square(double left, double right, double z, double radiance) {
  return {
      registry::FlatPolygon{{{left, -90, z}, {right, -90, z}, {right, 90, z}, {left, 90, z}}}, radiance, {}};
}

registry::DirectLight image_of(std::vector<registry::AnalyticSurface> surfaces, double environment = 0) {
  registry::DirectLight image;
  image.surfaces = std::move(surfaces);
  image.environment = environment;
  return image;
}

double seen(const registry::DirectLight& image, double x_m, double radius) {
  return analytic::ThinLensImage(image, camera(radius)).at(1 + x_m, 1);
}

// Where t is the place of a half plane's edge over the radius.
double share(double t) { return (std::acos(t) - t * std::sqrt(1 - t * t)) / std::numbers::pi; }

}  // namespace

TEST(ThinLens, AreaInADiskIsThatOfSegmentsAndPolygons) {
  EXPECT_NEAR(analytic::area_in_disk({{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}}, 2),
              4 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(analytic::area_in_disk({{0.1, 0.1, 0}, {0.4, 0.1, 0}, {0.1, 0.5, 0}}, 2), 0.06, 1e-12);
  EXPECT_NEAR(analytic::area_in_disk({{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}}, 1), std::numbers::pi / 4,
              1e-12);
  EXPECT_NEAR(analytic::area_in_disk({{0.5, -9, 0}, {9, -9, 0}, {9, 9, 0}, {0.5, 9, 0}}, 1),
              std::numbers::pi * share(0.5), 1e-12);
  EXPECT_NEAR(analytic::area_in_disk({{2, 2, 0}, {3, 2, 0}, {3, 3, 0}}, 1), 0, 1e-12);
}

// t = x D / (R |D - F|): a half plane to the right of x = 0, seen from the point in focus at x.
TEST(ThinLens, AHalfPlaneIsBlurredByTheStatedLaw) {
  EXPECT_NEAR(share(-0.5), 0.804499, 1e-6);
  EXPECT_NEAR(share(0.25), 0.342519, 1e-6);
  constexpr double kRadius = 0.4;
  for (const double z : {2.0, -4.0, 0.001}) {
    const double depth = 5 - z;
    for (const double t : {-0.5, 0.0, 0.25, 0.5, 1.5, -1.5}) {
      const double x = -t * kRadius * std::fabs(depth - 5) / depth;  // to the right it is inside
      EXPECT_NEAR(seen(image_of({square(0, 90, z, 1)}), x, kRadius), std::fabs(t) > 1 ? (t < 0) : share(t),
                  1e-9)
          << z << " " << t;
    }
  }
  EXPECT_EQ(seen(image_of({square(0, 90, 0, 1)}), 0.01, kRadius), 1) << "in focus";
  EXPECT_EQ(seen(image_of({square(0, 90, 0, 1)}), -0.01, kRadius), 0);
}

// Before the plane in focus the left half hides the right half of what is beyond it.
TEST(ThinLens, WhatIsNearerHidesItsShare) {
  const auto near_left = image_of({square(-90, 90, -4, 0.5), square(-90, 0, 2, 1)}, 0.1);
  EXPECT_NEAR(seen(near_left, 0, 0.4), 0.75, 1e-9);
  const auto other_way = image_of({square(-90, 0, 2, 1), square(-90, 90, -4, 0.5)}, 0.1);
  EXPECT_NEAR(seen(other_way, 0, 0.4), 0.75, 1e-9);
  // Both edges at the middle of the lens: the near one covers its left half, the far one its left half too,
  // as rays cross in the plane in focus. What is left is the environment.
  const auto both = image_of({square(-90, 0, 2, 1), square(0, 90, -4, 0.5)}, 0.1);
  EXPECT_NEAR(seen(both, 0, 0.4), 0.55, 1e-9);
}

TEST(ThinLens, OnlyGlowingPolygonsAtRestAreKnown) {
  auto lit = image_of({square(-1, 1, 0, 1)});
  lit.surfaces.front().reflectance = 0.5;
  EXPECT_THROW(analytic::analytic_image(lit, camera(0.1)), InputError);
  EXPECT_THROW(analytic::analytic_image(registry::MirrorCorridor{}, camera(0.1)), InputError);
  EXPECT_NO_THROW(analytic::analytic_image(registry::ConstantImage{}, camera(0.1)));
}

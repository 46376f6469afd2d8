#pragma once

#include "base/vec.h"
#include "property/chi_square.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

/// What tests of sampling routines against the densities that they state have in common.
namespace orbs::tests {

/// A file of such tests refuses right code with a probability below 1 in 1000, by Bonferroni's correction.
/// Seeds are fixed, so a result does not change from run to run.
constexpr int kMostDensityTests = 400;  // more than any of the files makes
constexpr double kDensityLevel = 1e-3 / kMostDensityTests;
constexpr std::size_t kTrials = 40000;

inline void expect_density(const ChiSquare& test, const std::string& name) {
  EXPECT_GT(test.p_value, kDensityLevel)
      << name << ": chi^2 " << test.statistic << " at " << test.degrees << " degrees of freedom; accepted "
      << test.accepted << ", the density integrates to " << test.integral;
}

/// Directions about an axis as (log r, phi), in which lobes of any width have about the same shape. r is the
/// length of the chord between direction and axis, so that r dr dphi is the solid angle.
class LogPolarMap {
 public:
  /// By default least_log is below the spacing of single-precision directions.
  explicit LogPolarMap(Vec3d axis, double least_log = -18) : least_log_(least_log), z_(normalised(axis)) {
    x_ = normalised(cross(std::abs(z_.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}, z_));
    y_ = cross(z_, x_);
  }
  Cell domain() const { return {{least_log_, -std::numbers::pi}, {std::log(2.0), std::numbers::pi}}; }
  Vec2d point_of(Vec3d direction) const {
    const Vec3d chord = normalised(direction) - z_;
    return {std::max(least_log_, std::log(length(chord))), std::atan2(dot(chord, y_), dot(chord, x_))};
  }
  Vec3d direction_of(Vec2d p) const {
    const double r = std::exp(p.x);
    const double sine = r * std::sqrt(std::max(0.0, 1 - r * r / 4));
    return z_ * (1 - r * r / 2) + x_ * (sine * std::cos(p.y)) + y_ * (sine * std::sin(p.y));
  }
  static double solid_angle_per_area(Vec2d p) { return std::exp(2 * p.x); }

 private:
  double least_log_;
  Vec3d z_;
  Vec3d x_;
  Vec3d y_;
};

}  // namespace orbs::tests

#pragma once

#include "base/vec.h"

#include <array>
#include <optional>

namespace orbs {

/// 4x4 matrix, stored row by row, for column vectors: p' = M p. The last row of an affine one is 0 0 0 1.
struct Mat4 {
  std::array<double, 16> m{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

  double operator()(std::size_t row, std::size_t column) const { return m[4 * row + column]; }
  double& operator()(std::size_t row, std::size_t column) { return m[4 * row + column]; }
  friend bool operator==(const Mat4& a, const Mat4& b) = default;
};

Mat4 operator*(const Mat4& a, const Mat4& b);

Mat4 translation(Vec3d offset);
Mat4 scaling(Vec3d factors);
/// Right-handed rotations about the axes.
Mat4 rotation_x(double degrees);
Mat4 rotation_y(double degrees);
Mat4 rotation_z(double degrees);

Vec3d transform_point(const Mat4& matrix, Vec3d point);
Vec3d transform_direction(const Mat4& matrix, Vec3d direction);
/// The result is not normalised. `inverse` is that of the points' matrix (inverse transpose rule).
Vec3d transform_normal(const Mat4& inverse, Vec3d normal);

/// Determinant of the upper-left 3x3.
double determinant3(const Mat4& matrix);
bool is_affine(const Mat4& matrix);
/// Inverse of an affine matrix. std::nullopt if the 3x3 part is singular for its size (|det| < 1e-12 |M|^3),
/// because the inverse would keep no correct digit in float, and if it or its inverse holds a number that is
/// not finite.
std::optional<Mat4> inverse(const Mat4& matrix);

}  // namespace orbs

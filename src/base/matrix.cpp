#include "base/matrix.h"

#include <algorithm>
#include <numbers>

namespace orbs {

Mat4 operator*(const Mat4& a, const Mat4& b) {
  Mat4 product;
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t column = 0; column < 4; ++column) {
      double sum = 0;
      for (std::size_t k = 0; k < 4; ++k) sum += a(row, k) * b(k, column);
      product(row, column) = sum;
    }
  return product;
}

Mat4 translation(Vec3d offset) {
  Mat4 matrix;
  matrix(0, 3) = offset.x;
  matrix(1, 3) = offset.y;
  matrix(2, 3) = offset.z;
  return matrix;
}

Mat4 scaling(Vec3d factors) {
  Mat4 matrix;
  matrix(0, 0) = factors.x;
  matrix(1, 1) = factors.y;
  matrix(2, 2) = factors.z;
  return matrix;
}

namespace {

// Rotation that takes axis `from` towards axis `to`.
Mat4 rotation(std::size_t from, std::size_t to, double degrees) {
  const double radians = degrees * std::numbers::pi / 180.0;
  Mat4 matrix;
  matrix(from, from) = std::cos(radians);
  matrix(to, to) = std::cos(radians);
  matrix(to, from) = std::sin(radians);
  matrix(from, to) = -std::sin(radians);
  return matrix;
}

}  // namespace

Mat4 rotation_x(double degrees) { return rotation(1, 2, degrees); }
Mat4 rotation_y(double degrees) { return rotation(2, 0, degrees); }
Mat4 rotation_z(double degrees) { return rotation(0, 1, degrees); }

Vec3d transform_point(const Mat4& m, Vec3d p) {
  return {m(0, 0) * p.x + m(0, 1) * p.y + m(0, 2) * p.z + m(0, 3),
          m(1, 0) * p.x + m(1, 1) * p.y + m(1, 2) * p.z + m(1, 3),
          m(2, 0) * p.x + m(2, 1) * p.y + m(2, 2) * p.z + m(2, 3)};
}

Vec3d transform_direction(const Mat4& m, Vec3d d) {
  return {m(0, 0) * d.x + m(0, 1) * d.y + m(0, 2) * d.z, m(1, 0) * d.x + m(1, 1) * d.y + m(1, 2) * d.z,
          m(2, 0) * d.x + m(2, 1) * d.y + m(2, 2) * d.z};
}

Vec3d transform_normal(const Mat4& i, Vec3d n) {
  return {i(0, 0) * n.x + i(1, 0) * n.y + i(2, 0) * n.z, i(0, 1) * n.x + i(1, 1) * n.y + i(2, 1) * n.z,
          i(0, 2) * n.x + i(1, 2) * n.y + i(2, 2) * n.z};
}

namespace {

Vec3d column3(const Mat4& m, std::size_t column) { return {m(0, column), m(1, column), m(2, column)}; }

}  // namespace

double determinant3(const Mat4& matrix) {
  return dot(column3(matrix, 0), cross(column3(matrix, 1), column3(matrix, 2)));
}

bool is_affine(const Mat4& matrix) {
  return matrix(3, 0) == 0 && matrix(3, 1) == 0 && matrix(3, 2) == 0 && matrix(3, 3) == 1;
}

std::optional<Mat4> inverse(const Mat4& matrix) {
  const Vec3d a = column3(matrix, 0);
  const Vec3d b = column3(matrix, 1);
  const Vec3d c = column3(matrix, 2);
  const double determinant = determinant3(matrix);
  const double size = std::max({length(a), length(b), length(c)});
  if (!(std::abs(determinant) > 1e-12 * size * size * size)) return std::nullopt;
  const std::array rows{cross(b, c) / determinant, cross(c, a) / determinant, cross(a, b) / determinant};
  const Vec3d offset = column3(matrix, 3);
  Mat4 result;
  for (std::size_t row = 0; row < 3; ++row) {
    result(row, 0) = rows[row].x;
    result(row, 1) = rows[row].y;
    result(row, 2) = rows[row].z;
    result(row, 3) = -dot(rows[row], offset);
  }
  const bool finite =
      std::all_of(result.m.begin(), result.m.end(), [](double x) { return std::isfinite(x); });
  return finite ? std::optional(result) : std::nullopt;
}

}  // namespace orbs

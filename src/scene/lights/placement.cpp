#include "scene/lights/placement.h"

#include <cmath>

namespace orbs::scene {

namespace {

Vec3d column(const Mat4& m, std::size_t i) { return {m(0, i), m(1, i), m(2, i)}; }

}  // namespace

double largest_entry(const Mat4& m) {
  double largest_so_far = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) largest_so_far = std::fmax(largest_so_far, std::fabs(m(i, j)));
  return largest_so_far;
}

bool is_translation(const Mat4& m) {
  const Mat4 moved = translation({m(0, 3), m(1, 3), m(2, 3)});
  return m == moved;
}

std::optional<double> uniform_scale(const Mat4& matrix) {
  const double size = length(column(matrix, 0));
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::fabs(length(column(matrix, i)) - size) > kMatrixRounding * size) return std::nullopt;
    for (std::size_t j = 0; j < i; ++j)
      if (std::fabs(dot(column(matrix, i), column(matrix, j))) > kMatrixRounding * size * size)
        return std::nullopt;
  }
  return size;
}

// The normal follows the inverse transpose, which for such a matrix has the sign of the entry Y -> Y.
bool stays_level(const Mat4& m) {
  const double zero = kMatrixRounding * largest_entry(m);
  return std::fabs(m(1, 0)) <= zero && std::fabs(m(1, 2)) <= zero && m(1, 1) > 0;
}

std::optional<double> level_scale(const Mat4& m) {
  if (!stays_level(m)) return std::nullopt;
  const Vec3d x = column(m, 0);
  const Vec3d z = column(m, 2);
  const double size = length(x);
  if (std::fabs(length(z) - size) > kMatrixRounding * size ||
      std::fabs(dot(x, z)) > kMatrixRounding * size * size)
    return std::nullopt;
  return size;
}

}  // namespace orbs::scene

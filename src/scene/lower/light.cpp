#include "scene/lower/light.h"

#include <cmath>
#include <utility>

namespace orbs::scene {

namespace {

// Sines and cosines of right angles come out as 6e-17 rather than 0; an entry this small beside the largest
// one counts as 0.
constexpr double kRounding = 1e-12;

Vec3d column(const Mat4& m, std::size_t i) { return {m(0, i), m(1, i), m(2, i)}; }

double largest_entry(const Mat4& m) {
  double largest_so_far = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) largest_so_far = std::fmax(largest_so_far, std::fabs(m(i, j)));
  return largest_so_far;
}

// True when X and Z stay in the plane of both and the side that shines still faces down (its normal follows
// the inverse transpose, which for such a matrix has the sign of the entry Y -> Y).
bool stays_level(const Mat4& m) {
  const double zero = kRounding * largest_entry(m);
  return std::fabs(m(1, 0)) <= zero && std::fabs(m(1, 2)) <= zero && m(1, 1) > 0;
}

struct ScaledShape {
  const Mat4& m;

  // A rectangle stays one along the axes when X goes to X and Z to Z, or each to the other.
  std::optional<LightShape> operator()(const RectShape& rect) const {
    if (!stays_level(m)) return std::nullopt;
    const double zero = kRounding * largest_entry(m);
    if (std::fabs(m(0, 2)) <= zero && std::fabs(m(2, 0)) <= zero)
      return RectShape{rect.half_width_m * std::fabs(m(0, 0)), rect.half_length_m * std::fabs(m(2, 2))};
    if (std::fabs(m(0, 0)) <= zero && std::fabs(m(2, 2)) <= zero)
      return RectShape{rect.half_length_m * std::fabs(m(0, 2)), rect.half_width_m * std::fabs(m(2, 0))};
    return std::nullopt;
  }
  // A disk stays one when X and Z keep their right angle and get the same length; a rotation about Y does not
  // change it.
  std::optional<LightShape> operator()(const DiskShape& disk) const {
    if (!stays_level(m)) return std::nullopt;
    const Vec3d x = column(m, 0);
    const Vec3d z = column(m, 2);
    const double size = length(x);
    if (std::fabs(length(z) - size) > kRounding * size || std::fabs(dot(x, z)) > kRounding * size * size)
      return std::nullopt;
    return DiskShape{disk.radius_m * size};
  }
  std::optional<LightShape> operator()(const SphereShape& sphere) const {
    const auto scale = uniform_scale(m);
    return scale ? std::optional<LightShape>(SphereShape{sphere.radius_m * *scale}) : std::nullopt;
  }
};

}  // namespace

bool is_translation(const Mat4& m) {
  Mat4 moved = translation({m(0, 3), m(1, 3), m(2, 3)});
  return m == moved;
}

std::optional<double> uniform_scale(const Mat4& matrix) {
  const double size = length(column(matrix, 0));
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::fabs(length(column(matrix, i)) - size) > kRounding * size) return std::nullopt;
    for (std::size_t j = 0; j < i; ++j)
      if (std::fabs(dot(column(matrix, i), column(matrix, j))) > kRounding * size * size) return std::nullopt;
  }
  return size;
}

std::optional<Light> without_matrix(const Light& light) {
  if (is_translation(light.matrix)) return light;
  // The profile rotates and scales with the frame of the light; only a uniform scale leaves it unchanged.
  const bool only_scaled = light.matrix(0, 0) > 0 && light.matrix(1, 1) > 0 && light.matrix(2, 2) > 0 &&
                           light.matrix(0, 1) == 0 && light.matrix(0, 2) == 0 && light.matrix(1, 2) == 0 &&
                           uniform_scale(light.matrix);
  if (light.ies && !only_scaled) return std::nullopt;
  const auto shape = std::visit(ScaledShape{light.matrix}, light.shape);
  if (!shape) return std::nullopt;
  Light moved = light;
  moved.shape = *shape;
  moved.matrix = translation({light.matrix(0, 3), light.matrix(1, 3), light.matrix(2, 3)});
  return moved;
}

}  // namespace orbs::scene

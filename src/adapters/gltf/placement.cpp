#include "adapters/gltf/placement.h"

#include <cmath>

namespace orbs::adapters::gltf {

namespace {

// Sines and cosines of right angles come out as 6e-17 rather than 0; so do products of turned and turned back
// matrices. A cosine below this between two axes is rounding.
constexpr double kRounding = 1e-12;

bool is_right_angle(Vec3d a, Vec3d b) { return std::abs(dot(a, b)) <= kRounding * length(a) * length(b); }

// The unit quaternion of a rotation by its axes; it begins with its largest component, which loses no digits
// (Shepperd 1978).
std::array<double, 4> quaternion_of(Vec3d x, Vec3d y, Vec3d z) {
  const std::array squares{1 + x.x - y.y - z.z, 1 - x.x + y.y - z.z, 1 - x.x - y.y + z.z,
                           1 + x.x + y.y + z.z};  // 4 times that of each component
  std::size_t largest = 3;
  for (std::size_t i = 0; i < 3; ++i)
    if (squares[i] > squares[largest]) largest = i;
  std::array<double, 4> q{};
  switch (largest) {
    case 0:
      q = {squares[0], x.y + y.x, z.x + x.z, y.z - z.y};
      break;
    case 1:
      q = {x.y + y.x, squares[1], y.z + z.y, z.x - x.z};
      break;
    case 2:
      q = {z.x + x.z, y.z + z.y, squares[2], x.y - y.x};
      break;
    default:
      q = {y.z - z.y, z.x - x.z, x.y - y.x, squares[3]};
  }
  const double size = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (double& component : q) component /= size;
  return q;
}

}  // namespace

std::optional<Placement> placement_of(const Mat4& matrix) {
  const Vec3d x = transform_direction(matrix, {1, 0, 0});
  const Vec3d y = transform_direction(matrix, {0, 1, 0});
  const Vec3d z = transform_direction(matrix, {0, 0, 1});
  if (!is_right_angle(x, y) || !is_right_angle(y, z) || !is_right_angle(z, x)) return std::nullopt;
  const double hand = dot(cross(x, y), z) < 0 ? -1 : 1;
  const Vec3d scale{hand * length(x), length(y), length(z)};
  return Placement{transform_point(matrix, {}), quaternion_of(x / scale.x, y / scale.y, z / scale.z), scale};
}

// With v = 1 - v_top, u' = a u + b v + c and v' = d u + e v + f become
//   u'     = a u - b v_top + b + c
//   v_top' = -d u + e v_top + 1 - e - f.
// The extension computes, with s, t the scale and r the rotation, counter-clockwise as one sees it,
//   u'     = s cos(r) u + t sin(r) v_top + offset
//   v_top' = -s sin(r) u + t cos(r) v_top + offset.
// The README has had another sign of its sines; its example, the lower left quarter of an image turned by 90
// degrees, holds with these alone, and they are what Blender computes.
std::optional<TextureTransform> texture_transform_of(const Mat4& matrix) {
  const double a = matrix(0, 0);
  const double b = matrix(0, 1);
  const double d = matrix(1, 0);
  const double e = matrix(1, 1);
  const double s = std::hypot(a, d);
  if (s == 0 || std::abs(a * b + d * e) > kRounding * s * std::hypot(b, e)) return std::nullopt;
  const double t = (a * e - b * d) / s;
  return TextureTransform{
      {b + matrix(0, 3), 1 - e - matrix(1, 3)}, d == 0 && a > 0 ? 0 : std::atan2(d, a), {s, t}};
}

}  // namespace orbs::adapters::gltf

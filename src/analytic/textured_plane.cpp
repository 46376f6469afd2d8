#include "analytic/textured_plane.h"

#include "base/nth.h"

#include <algorithm>
#include <cmath>

namespace orbs::analytic {

namespace {

// The index of the texel that stands at `index` among `count`, by the words of the scene format.
int texel_at(double index, int count, registry::PlaneWrap wrap) {
  if (wrap == registry::PlaneWrap::Clamp) return static_cast<int>(std::clamp(index, 0.0, count - 1.0));
  const double period = wrap == registry::PlaneWrap::Mirror ? 2.0 * count : count;
  const int within = static_cast<int>(index - period * std::floor(index / period));
  return within < count ? within : 2 * count - 1 - within;
}

std::array<double, 3> texel(const registry::TexturedPlane& plane, double column, double row) {
  const int rows = static_cast<int>(plane.texels.size()) / plane.columns;
  const int x = texel_at(column, plane.columns, plane.wrap[0]);
  const int y = texel_at(row, rows, plane.wrap[1]);
  return nth(plane.texels, y * plane.columns + x);
}

std::array<double, 3> mixed(const std::array<double, 3>& a, const std::array<double, 3>& b, double share) {
  std::array<double, 3> out{};
  for (std::size_t c = 0; c < 3; ++c) out.at(c) = (1 - share) * a.at(c) + share * b.at(c);
  return out;
}

}  // namespace

std::array<double, 3> textured_plane(const registry::TexturedPlane& plane, const Ray& ray) {
  const Vec3d normal = cross(plane.u_edge, plane.v_edge);
  const double along = dot(normal, ray.direction);
  const double distance = dot(normal, plane.origin - ray.origin) / along;
  if (along == 0 || !(distance > 0)) return {};
  const Vec3d at = ray.origin + ray.direction * distance - plane.origin;
  const double size = dot(normal, normal);
  const int rows = static_cast<int>(plane.texels.size()) / plane.columns;
  // By Cramer's rule in the plane.
  const double x = dot(cross(at, plane.v_edge), normal) / size * plane.columns;
  const double y = dot(cross(plane.u_edge, at), normal) / size * rows;
  std::array<double, 3> value{};
  if (plane.is_nearest) {
    value = texel(plane, std::floor(x), std::floor(y));
  } else {
    const double left = std::floor(x - 0.5);
    const double low = std::floor(y - 0.5);
    value = mixed(mixed(texel(plane, left, low), texel(plane, left + 1, low), x - 0.5 - left),
                  mixed(texel(plane, left, low + 1), texel(plane, left + 1, low + 1), x - 0.5 - left),
                  y - 0.5 - low);
  }
  for (double& channel : value) channel *= plane.radiance;
  return value;
}

}  // namespace orbs::analytic

#include "tracer/light/spherical_rectangle.h"

#include "tracer/sampling/warps.h"

#include <algorithm>
#include <cmath>

namespace orbs::tracer {

std::optional<SphericalRectangle> make_spherical_rectangle(Vec3f centre,
                                                           Vec3f half_width,
                                                           Vec3f half_length,
                                                           Vec3f from) {
  SphericalRectangle r;
  r.from = from;
  const float width = 2 * length(half_width);
  const float height = 2 * length(half_length);
  r.x = half_width * (2 / width);
  r.y = half_length * (2 / height);
  r.z = cross(r.x, r.y);
  const Vec3f d = centre - half_width - half_length - from;
  r.z0 = dot(d, r.z);
  if (r.z0 > 0) {
    r.z = -r.z;
    r.z0 = -r.z0;
  }
  if (r.z0 == 0) return std::nullopt;  // seen edge-on
  r.x0 = dot(d, r.x);
  r.y0 = dot(d, r.y);
  r.x1 = r.x0 + width;
  r.y1 = r.y0 + height;
  // z components of the normals of the four side planes: -coordinate / hypot(z0, coordinate).
  const auto plane = [&](float coordinate) { return coordinate / std::hypot(r.z0, coordinate); };
  const float n0 = -plane(r.y0);
  const float n1 = plane(r.x1);
  const float n2 = plane(r.y1);
  const float n3 = -plane(r.x0);
  // The clamp is for rounding only.
  const auto angle = [](float a, float b) { return std::acos(std::clamp(-a * b, -1.0F, 1.0F)); };
  const float g0 = angle(n0, n1);
  const float g1 = angle(n1, n2);
  const float g2 = angle(n2, n3);
  const float g3 = angle(n3, n0);
  r.b0 = n0;
  r.b1 = n2;
  r.k = 2 * kPi - g2 - g3;
  r.solid_angle = g0 + g1 - r.k;
  if (!(r.solid_angle > 1e-2F)) return std::nullopt;
  return r;
}

Vec3f sample_point(const SphericalRectangle& r, float u, float v) {
  const float au = u * r.solid_angle + r.k;
  const float fu = (std::cos(au) * r.b0 - r.b1) / std::sin(au);
  // The clamps below are for rounding only: the exact values lie within the edges (Urena et al. 2013, 4.1).
  const float cu = std::clamp(std::copysign(1 / std::sqrt(fu * fu + r.b0 * r.b0), fu), -1.0F, 1.0F);
  const float xu = std::clamp(-(cu * r.z0) / std::sqrt(std::max(1e-12F, 1 - cu * cu)), r.x0, r.x1);
  const float d2 = xu * xu + r.z0 * r.z0;
  const float d = std::sqrt(d2);
  const float h0 = r.y0 / std::sqrt(d2 + r.y0 * r.y0);
  const float h1 = r.y1 / std::sqrt(d2 + r.y1 * r.y1);
  const float hv = h0 + v * (h1 - h0);
  const float yv = hv * hv < 1 - 1e-6F ? hv * d / std::sqrt(1 - hv * hv) : r.y1;
  return r.from + r.x * xu + r.y * std::clamp(yv, r.y0, r.y1) + r.z * r.z0;
}

}  // namespace orbs::tracer

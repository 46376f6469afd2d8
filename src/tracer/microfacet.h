#pragma once

#include "base/vec.h"
#include "tracer/sampling.h"

#include <cmath>

/// GGX, isotropic, in the local frame (z = macroscopic normal). Walter et al. 2007; Heitz 2014 and 2018.
namespace orbs::tracer {

/// Distribution of microfacet normals, per solid angle. Walter eq. 33 written with the components of m: 1 -
/// cos^2 would lose its digits next to the highlight (19 % wrong in float at alpha = 1e-3).
inline float ggx_d(Vec3f m, float alpha) {
  if (m.z <= 0) return 0;
  const float x = m.x / alpha;
  const float y = m.y / alpha;
  const float s = x * x + y * y + m.z * m.z;
  return 1 / (kPi * alpha * alpha * s * s);
}

/// Smith's Lambda (Heitz 2014, eq. 72).
inline float ggx_lambda(Vec3f w, float alpha) {
  const float cos2 = w.z * w.z;
  if (cos2 == 0) return INFINITY;
  const float tan2 = (w.x * w.x + w.y * w.y) / cos2;
  return 0.5F * (std::sqrt(1 + alpha * alpha * tan2) - 1);
}

/// Share of the facets that w sees.
inline float ggx_g1(Vec3f w, float alpha) { return 1 / (1 + ggx_lambda(w, alpha)); }

/// Share seen by both, heights correlated (Heitz 2014, eq. 99); both directions on one side.
inline float ggx_g2(Vec3f wo, Vec3f wi, float alpha) {
  return 1 / (1 + ggx_lambda(wo, alpha) + ggx_lambda(wi, alpha));
}

/// A facet normal as wo (wo.z > 0) sees them; Heitz 2018, "Sampling the GGX Distribution of Visible Normals",
/// listing 1. Density: ggx_visible_d.
inline Vec3f sample_ggx_visible(Vec3f wo, float alpha, float u, float v) {
  const Vec3f view = normalised(Vec3f{alpha * wo.x, alpha * wo.y, wo.z});
  const float across2 = view.x * view.x + view.y * view.y;
  const Vec3f t1 = across2 > 0 ? Vec3f{-view.y, view.x, 0} / std::sqrt(across2) : Vec3f{1, 0, 0};
  const Vec3f t2 = cross(view, t1);
  const Vec2f d = sample_disk(u, v);
  const float s = 0.5F * (1 + view.z);
  const float y = (1 - s) * std::sqrt(std::max(0.0F, 1 - d.x * d.x)) + s * d.y;
  // Rounding only: x^2 + y^2 <= 1 on the projected hemisphere.
  const float z = std::sqrt(std::max(0.0F, 1 - d.x * d.x - y * y));
  const Vec3f n = t1 * d.x + t2 * y + view * z;
  return normalised(
      Vec3f{alpha * n.x, alpha * n.y, std::max(1e-9F, n.z)});  // 1e-9: keeps the facet above the horizon
}

inline float ggx_visible_d(Vec3f wo, Vec3f m, float alpha) {
  return ggx_g1(wo, alpha) * std::abs(dot(wo, m)) * ggx_d(m, alpha) / wo.z;
}

}  // namespace orbs::tracer

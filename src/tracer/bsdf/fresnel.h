#pragma once

#include "base/vec.h"

#include <cmath>
#include <optional>

/// Refraction at microfacets (Walter et al. 2007). `eta` is the index beyond the surface over the index on
/// the viewer's side.

namespace orbs::tracer {

/// Normal of the microfacet that reflects or refracts wo to wi, on the side of wo; nothing if there is none.
inline std::optional<Vec3f> facet_between(Vec3f wo, Vec3f wi, float eta) {
  if (wi.z == 0) return std::nullopt;
  const bool reflects = wi.z > 0;
  const Vec3f half = reflects ? wo + wi : wo + wi * eta;
  if (dot(half, half) == 0) return std::nullopt;  // eta = 1 and undeviated
  const Vec3f m = normalised(half) * (half.z < 0 ? -1.0F : 1.0F);
  // Backfacing microfacets are discarded.
  if (dot(wo, m) <= 0 || (dot(wi, m) > 0) != reflects) return std::nullopt;
  return m;
}

/// Solid angle of m per solid angle of a transmitted wi (eq. 17, with both indices divided by that of the
/// viewer's side).
inline float refraction_jacobian(float cos_o, float cos_i, float eta) {
  const float root = cos_i + cos_o / eta;
  return -cos_i / (root * root);
}

/// Unpolarised Fresnel reflectance of a smooth dielectric (ORB.S eq. 7 with sin_t = sin_i / eta; the printed
/// form has the division under the root). cos_i in (0, 1]; eta = index of the transmitted over the incident
/// side. 1 at total internal reflection.
inline float fresnel_dielectric(float cos_i, float eta) {
  const float sin2_t = (1 - cos_i * cos_i) / (eta * eta);
  if (sin2_t >= 1) return 1;
  const float cos_t = std::sqrt(1 - sin2_t);
  const float parallel = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
  const float perpendicular = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
  return 0.5F * (parallel * parallel + perpendicular * perpendicular);
}

/// Direction of `wo` refracted at a surface with normal m on the side of wo (dot(wo, m) > 0), by Snell's law
/// in vector form (ORB.S eq. 9); nothing at total internal reflection.
inline std::optional<Vec3f> refracted(Vec3f wo, Vec3f m, float eta) {
  const float cos_o = dot(wo, m);
  const float sin2_t = (1 - cos_o * cos_o) / (eta * eta);
  if (sin2_t >= 1) return std::nullopt;
  return wo * (-1 / eta) + m * (cos_o / eta - std::sqrt(1 - sin2_t));
}

}  // namespace orbs::tracer

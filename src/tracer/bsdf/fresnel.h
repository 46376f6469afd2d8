#pragma once

#include "base/vec.h"

#include <cmath>
#include <optional>

/// Refraction at microfacets (Walter et al. 2007). `eta` is the index beyond the surface over the index on
/// the viewer's side.
namespace orbs::tracer {

/// cos_o / eta - cos_t of a refraction, where both are positive. By Snell's law it is (1 / eta^2 - 1) over
/// their sum, which does not cancel next to eta = 1.
template <typename Real>
constexpr Real refraction_bend(Real cos_o, Real cos_t, Real eta) {
  return (1 - eta) * (1 + eta) / (eta * eta * (cos_o / eta + cos_t));
}

/// Direction of `wo` refracted at a microfacet m with dot(wo, m) > 0; nothing at total internal reflection.
/// In double, so that only the result is rounded: next to eta = 1 all directions of the lobe lie within a few
/// ulps of -wo.
inline std::optional<Vec3f> refracted_at_facet(Vec3f wo, Vec3f m, float eta) {
  const Vec3d o = normalised(cast<double>(wo));
  const Vec3d n = normalised(cast<double>(m));
  const double index = eta;
  const double cos_o = dot(o, n);
  const double sin2_t = (1 - cos_o * cos_o) / (index * index);
  if (sin2_t >= 1) return std::nullopt;
  return cast<float>(o * (-1 / index) + n * refraction_bend(cos_o, std::sqrt(1 - sin2_t), index));
}

/// Normal of the microfacet that refracts wo to wi, on the side of wo; nothing if there is none. wo + eta wi
/// is no longer than |eta - 1| next to eta = 1, where the rounding of floats to 6e-8 would turn it by as much
/// as the lobe is wide; that their length is not exactly 1 would, too.
inline std::optional<Vec3f> refracting_facet(Vec3f wo, Vec3f wi, float eta) {
  if (eta == 1) return std::nullopt;  // whatever the facet, it bends nothing
  const Vec3d o = normalised(cast<double>(wo));
  const Vec3d i = normalised(cast<double>(wi));
  const Vec3d half = o + i * static_cast<double>(eta);
  if (dot(half, half) == 0) return std::nullopt;
  const Vec3d m = normalised(half) * (half.z < 0 ? -1.0 : 1.0);
  if (dot(o, m) <= 0 || dot(i, m) > 0) return std::nullopt;  // back-facing
  return cast<float>(m);
}

/// Normal of the microfacet that reflects or refracts wo to wi, on the side of wo; nothing if there is none.
inline std::optional<Vec3f> facet_between(Vec3f wo, Vec3f wi, float eta) {
  if (wi.z == 0) return std::nullopt;
  if (wi.z < 0) return refracting_facet(wo, wi, eta);
  const Vec3f m = normalised(wo + wi);
  if (dot(wo, m) <= 0 || dot(wi, m) <= 0) return std::nullopt;  // back-facing
  return m;
}

/// Solid angle of m per solid angle of a transmitted wi (eq. 17, with both indices divided by that of the
/// viewer's side). cos_i = dot(wi, m) is not positive.
inline float refraction_jacobian(float cos_o, float cos_i, float eta) {
  const float bend = refraction_bend(cos_o, -cos_i, eta);
  return -cos_i / (bend * bend);
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

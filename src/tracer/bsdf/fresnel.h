#pragma once

#include "base/in_double.h"
#include "base/vec.h"
#include "tracer/numeric_fault.h"

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

/// Next to an index of 1 what refracts one direction into the other follows from their difference, which is
/// no longer than |eta - 1|: the rounding of floats to 6e-8 would turn it by as much as a lobe is wide.
/// Farther off, floats know it to 1e-6.
inline bool is_next_to_one(float eta) { return std::abs(eta - 1) < 0.1F; }

/// See refracting_facet.
template <typename Real>
std::optional<Vec3f> refracting_facet_as_is(Vec3<Real> wo, Vec3<Real> wi, Real eta) {
  const Vec3<Real> half = wo + wi * eta;
  if (dot(half, half) == 0) return std::nullopt;
  const Vec3<Real> m = normalised(half) * (half.z < 0 ? Real(-1) : Real(1));
  if (dot(wo, m) <= 0 || dot(wi, m) > 0) return std::nullopt;  // back-facing
  return cast<float>(m);
}

/// Normal of the microfacet that refracts wo to wi, on the side of wo; nothing if there is none. That the
/// length of floats' directions is not exactly 1 counts next to eta = 1, too.
inline std::optional<Vec3f> refracting_facet(Vec3f wo, Vec3f wi, float eta) {
  if (eta == 1) return std::nullopt;  // whatever the facet, it bends nothing
  if (!is_next_to_one(eta)) return refracting_facet_as_is(wo, wi, eta);
  return refracting_facet_as_is<double>(normalised(cast<double>(wo)), normalised(cast<double>(wi)), eta);
}

/// The microfacet m that refracted wo to wi, as it follows from wi when that is rounded: next to eta = 1 that
/// is another one than m, and the weights of MIS need one pdf for one direction. Without one, light sampling
/// cannot find wi.
inline std::optional<Vec3f> facet_as_rounded(Vec3f wo, Vec3f wi, Vec3f m, float eta) {
  return is_next_to_one(eta) ? refracting_facet(wo, wi, eta) : m;
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
  if (has_fault(NumericFault::FresnelBySchlick)) {
    const float at_normal = (eta - 1) * (eta - 1) / ((eta + 1) * (eta + 1));
    return at_normal + (1 - at_normal) * in_double::pow(1 - cos_i, 5.0F);
  }
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

/// The same at a microfacet. Next to eta = 1 all directions of the lobe lie within a few ulps of -wo, so that
/// only the result is rounded there.
inline std::optional<Vec3f> refracted_at_facet(Vec3f wo, Vec3f m, float eta) {
  if (!is_next_to_one(eta)) return refracted(wo, m, eta);
  const Vec3d o = normalised(cast<double>(wo));
  const Vec3d n = normalised(cast<double>(m));
  const double index = eta;
  const double cos_o = dot(o, n);
  const double sin2_t = (1 - cos_o * cos_o) / (index * index);
  if (sin2_t >= 1) return std::nullopt;
  return cast<float>(o * (-1 / index) + n * refraction_bend(cos_o, std::sqrt(1 - sin2_t), index));
}

}  // namespace orbs::tracer

#pragma once

#include "base/vec.h"

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

}  // namespace orbs::tracer

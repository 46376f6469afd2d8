#pragma once

#include "base/vec.h"

#include <optional>

/// Facets that refract (Walter et al. 2007). `eta` = index beyond the surface over the index on the viewer's
/// side.
namespace orbs::tracer {

/// The facet, on the side of wo, that takes wo to wi; nothing where none does.
inline std::optional<Vec3f> facet_between(Vec3f wo, Vec3f wi, float eta) {
  if (wi.z == 0) return std::nullopt;
  const bool reflects = wi.z > 0;
  const Vec3f half = reflects ? wo + wi : wo + wi * eta;
  if (dot(half, half) == 0) return std::nullopt;  // eta = 1 straight through
  const Vec3f m = normalised(half) * (half.z < 0 ? -1.0F : 1.0F);
  // It must not face away from one of the two.
  if (dot(wo, m) <= 0 || (dot(wi, m) > 0) != reflects) return std::nullopt;
  return m;
}

/// Solid angle of a transmitted wi per solid angle of m: eq. 17 with both indices over the viewer's side's.
inline float refraction_jacobian(float cos_o, float cos_i, float eta) {
  const float root = cos_i + cos_o / eta;
  return -cos_i / (root * root);
}

}  // namespace orbs::tracer

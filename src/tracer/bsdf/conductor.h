#pragma once

#include "tracer/bsdf/bsdf_sample.h"
#include "tracer/bsdf/boundary.h"
#include "tracer/bsdf/microfacets.h"
#include "tracer/bsdf/broadcast.h"

#include <array>
#include <optional>

namespace orbs::tracer {

/// A smooth metal: reflects by Fresnel's formulas, or Airy's where a film lies on it.
template <typename Value, std::size_t N>
struct ConductorBsdf {
  static constexpr bool kIsDelta = true;
  static constexpr Event kEvent = Event::Specular;
  Boundary<N> boundary;
};

template <typename Value, std::size_t N>
BsdfValue<Value> evaluate(const ConductorBsdf<Value, N>&, Vec3f, Vec3f) {
  return {};
}

template <typename Value, std::size_t N>
std::optional<BsdfSample<Value>> sample(const ConductorBsdf<Value, N>& bsdf,
                                        Vec3f wo,
                                        const std::array<float, 4>&) {
  return BsdfSample<Value>{.wi = {-wo.x, -wo.y, wo.z},
                           .weight = broadcast<Value>(reflectances(bsdf.boundary, wo.z))};
}

/// Facets of that: f = F(wo.m) D(m) G2(wo, wi) / (4 cos cos) (Walter et al. 2007, eq. 20).
template <typename Value, std::size_t N>
struct RoughConductorBsdf {
  static constexpr bool kIsDelta = false;
  static constexpr Event kEvent = Event::Glossy;
  Boundary<N> boundary;
  Microfacets facets;
};

template <typename Value, std::size_t N>
BsdfValue<Value> evaluate(const RoughConductorBsdf<Value, N>& bsdf, Vec3f wo, Vec3f wi) {
  if (wi.z <= 0) return {};
  const Vec3f m = normalised(wo + wi);
  const float cos_o = dot(wo, m);
  const float f_cos = facet_density(bsdf.facets, m) * facet_g2(bsdf.facets, wo, wi) / (4 * wo.z);
  return {broadcast<Value>(reflectances(bsdf.boundary, cos_o)) * f_cos,
          facet_pdf(bsdf.facets, wo, m) / (4 * cos_o)};
}

template <typename Value, std::size_t N>
std::optional<BsdfSample<Value>> sample(const RoughConductorBsdf<Value, N>& bsdf,
                                        Vec3f wo,
                                        const std::array<float, 4>& u) {
  const Vec3f m = sample_facet(bsdf.facets, wo, u[0], u[1]);
  const float cos_o = dot(wo, m);
  if (cos_o <= 0) return std::nullopt;
  const Vec3f wi = m * (2 * cos_o) - wo;
  if (wi.z <= 0) return std::nullopt;  // the facet reflects below the horizon: masked
  const float g1 = snippets::smith_g1(facet_lambda(bsdf.facets, wo));
  return BsdfSample<Value>{
      .wi = wi,
      .weight = broadcast<Value>(reflectances(bsdf.boundary, cos_o)) * (facet_g2(bsdf.facets, wo, wi) / g1),
      .pdf = facet_pdf(bsdf.facets, wo, m) / (4 * cos_o)};
}

}  // namespace orbs::tracer

#pragma once

#include "tracer/bsdf/boundary_bsdf.h"
#include "tracer/bsdf/broadcast.h"
#include "tracer/bsdf/bsdf_sample.h"
#include "tracer/bsdf/lambert.h"
#include "tracer/bsdf/microfacets.h"
#include "tracer/bsdf/polarisation.h"

#include <array>
#include <optional>

namespace orbs::tracer {

/// A smooth metal, which reflects by Fresnel's equations, or by Airy's sum if it is coated with a film.
template <typename Value, std::size_t N>
struct ConductorBsdf : SmoothBoundaryBsdf<Value, N> {};

template <typename Value, std::size_t N>
std::optional<BsdfSample<Value>> sample(const ConductorBsdf<Value, N>& bsdf,
                                        Vec3f wo,
                                        const std::array<float, 4>&) {
  return BsdfSample<Value>{.wi = {-wo.x, -wo.y, wo.z},
                           .weight = broadcast<Value>(reflectances(bsdf.boundary, wo.z))};
}

/// A metal with microfacets: f = F(wo.m) D(m) G2(wo, wi) / (4 cos cos) (Walter et al. 2007, eq. 20).
template <typename Value, std::size_t N>
struct RoughConductorBsdf : RoughBoundaryBsdf<Value, N> {};

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
  if (wi.z <= 0) return std::nullopt;  // the microfacet reflects below the horizon: masked
  const float g1 = snippets::smith_g1(facet_lambda(bsdf.facets, wo));
  return BsdfSample<Value>{
      .wi = wi,
      .weight = broadcast<Value>(reflectances(bsdf.boundary, cos_o)) * (facet_g2(bsdf.facets, wo, wi) / g1),
      .pdf = facet_pdf(bsdf.facets, wo, m) / (4 * cos_o)};
}

template <typename Value, std::size_t N>
std::optional<Polarisation> polarisation_by(const RoughConductorBsdf<Value, N>& bsdf,
                                            const auto& scattering) {
  return facet_polarisation(bsdf.boundary, normalised(scattering.wo + scattering.wi), scattering);
}

struct ConductorMaterial {
  static constexpr bool kIsAppearance = true;
  template <typename Value, std::size_t N>
  using Bsdfs = BsdfList<ConductorBsdf<Value, N>, RoughConductorBsdf<Value, N>>;
  scene::Conductor metal;
};

inline ConductorMaterial make_material(const scene::Conductor& m, const SceneColours&) { return {m}; }

inline float lobe_alpha(const ConductorMaterial& material) { return lobe_alpha(material.metal.roughness); }

template <typename Context>
void make_bsdf(typename Context::Bsdf& out, const ConductorMaterial& material, const Context& at) {
  using Value = typename Context::Value;
  constexpr auto kN = Context::kWavelengths;
  if (!at.is_outside) {
    out = LambertBsdf<Value>{};  // a conductor is black from behind
    return;
  }
  const scene::Conductor& metal = material.metal;
  const auto boundary = boundary_between<kN>(at.wavelengths_nm(), metal.outside, metal.index, metal.film);
  if (metal.roughness)
    out = RoughConductorBsdf<Value, kN>{{boundary, microfacets(*metal.roughness)}};
  else
    out = ConductorBsdf<Value, kN>{{boundary}};
}

}  // namespace orbs::tracer

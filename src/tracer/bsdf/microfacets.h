#pragma once

#include "scene/spectral.h"
#include "snippets/ggx.h"
#include "tracer/sampling/warps.h"

namespace orbs::tracer {

/// Isotropic facets of either distribution, with either masking, chosen at run time.
struct Microfacets {
  float alpha = 0.1F;
  bool is_beckmann = false;
  bool is_correlated = false;
};

inline Microfacets microfacets(const scene::Roughness& roughness) {
  return {static_cast<float>(roughness.alpha), roughness.distribution == scene::Distribution::Beckmann,
          roughness.masking == scene::Masking::Correlated};
}

inline float facet_density(const Microfacets& facets, Vec3f m) {
  return facets.is_beckmann ? snippets::beckmann_d(m, facets.alpha) : snippets::ggx_d(m, facets.alpha);
}

/// Smith's Lambda.
inline float facet_lambda(const Microfacets& facets, Vec3f w) {
  return facets.is_beckmann ? snippets::beckmann_lambda(w, facets.alpha)
                            : snippets::ggx_lambda(w, facets.alpha);
}

/// Share of the facets that both directions see.
inline float facet_g2(const Microfacets& facets, Vec3f wo, Vec3f wi) {
  const float lambda_o = facet_lambda(facets, wo);
  const float lambda_i = facet_lambda(facets, wi);
  return facets.is_correlated ? snippets::smith_g2_correlated(lambda_o, lambda_i)
                              : snippets::smith_g2_separable(lambda_o, lambda_i);
}

/// A facet as wo sees them, and its density per solid angle of m.
inline Vec3f sample_facet(const Microfacets& facets, Vec3f wo, float u, float v) {
  return facets.is_beckmann ? snippets::sample_beckmann_visible(wo, facets.alpha, u, v)
                            : snippets::sample_ggx_visible(wo, facets.alpha, sample_disk(u, v));
}
inline float facet_pdf(const Microfacets& facets, Vec3f wo, Vec3f m) {
  return snippets::smith_g1(facet_lambda(facets, wo)) * std::abs(dot(wo, m)) * facet_density(facets, m) /
         wo.z;
}

}  // namespace orbs::tracer

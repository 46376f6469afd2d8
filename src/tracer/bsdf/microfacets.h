#pragma once

#include "scene/spectral.h"
#include "snippets/ggx.h"
#include "tracer/bsdf/bsdf_sample.h"
#include "tracer/sampling/warps.h"

#include <optional>

namespace orbs::tracer {

/// Isotropic microfacets: GGX or Beckmann, separable or height-correlated masking, chosen at run time.
struct Microfacets {
  float alpha = 0.1F;
  bool is_beckmann = false;
  bool is_correlated = false;
};

inline Microfacets microfacets(const scene::Roughness& roughness) {
  return {static_cast<float>(roughness.alpha), roughness.distribution == scene::Distribution::Beckmann,
          roughness.masking == scene::Masking::Correlated};
}

/// Of an appearance material, which is smooth without a roughness.
inline float lobe_alpha(const std::optional<scene::Roughness>& roughness) {
  return roughness ? static_cast<float>(roughness->alpha) : 0;
}

inline float facet_density(const Microfacets& facets, Vec3f m) {
  return facets.is_beckmann ? snippets::beckmann_d(m, facets.alpha) : snippets::ggx_d(m, facets.alpha);
}

/// Smith's auxiliary function Lambda.
inline float facet_lambda(const Microfacets& facets, Vec3f w) {
  return facets.is_beckmann ? snippets::beckmann_lambda(w, facets.alpha)
                            : snippets::ggx_lambda(w, facets.alpha);
}

/// Masking-shadowing G2 of both directions.
inline float facet_g2(const Microfacets& facets, Vec3f wo, Vec3f wi) {
  const float lambda_o = facet_lambda(facets, wo);
  const float lambda_i = facet_lambda(facets, wi);
  return facets.is_correlated ? snippets::smith_g2_correlated(lambda_o, lambda_i)
                              : snippets::smith_g2_separable(lambda_o, lambda_i);
}

/// Samples the distribution of normals visible from wo (Heitz 2014); facet_pdf is per solid angle of m.
inline Vec3f sample_facet(const Microfacets& facets, Vec3f wo, float u, float v) {
  return facets.is_beckmann ? snippets::sample_beckmann_visible(wo, facets.alpha, u, v)
                            : snippets::sample_ggx_visible(wo, facets.alpha, sample_disk(u, v));
}
inline float facet_pdf(const Microfacets& facets, Vec3f wo, Vec3f m) {
  return snippets::smith_g1(facet_lambda(facets, wo)) * std::abs(dot(wo, m)) * facet_density(facets, m) /
         wo.z;
}

}  // namespace orbs::tracer

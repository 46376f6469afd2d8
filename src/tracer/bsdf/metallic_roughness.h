#pragma once

#include "tracer/bsdf/metal.h"
#include "tracer/bsdf/microfacets.h"

#include <array>
#include <optional>

namespace orbs::tracer {

/// The BRDF of glTF 2.0 (appendix B.3.5 of its specification), with w = (1 - cos)^5 at the microfacet:
///   dielectric: (1 - Fd) base / pi + Fd V D,  Fd = 0.04 + 0.96 w
///   metal:      (base + (1 - base) w) V D
/// mixed by `metallic`. D is that of ggx, and V is G1 G1 / (4 cos cos): the specification has the separable
/// form. It is reciprocal and not energy conserving: in the specification Fd takes from the diffuse part at
/// the microfacet, not at the surface.
template <typename Value>
struct MetallicRoughnessBsdf {
  static constexpr bool kIsDelta = false;
  static constexpr bool kDepolarises = true;
  static constexpr Event kEvent = Event::Glossy;
  Value base{};
  float metallic = 0;
  float alpha = 1;
};

/// The share of samples that the microfacets get. A dielectric reflects 4 % at normal incidence and all at
/// grazing angles; half finds both parts with at most twice the samples that either needs.
inline float facet_share(float metallic) { return 0.5F + 0.5F * metallic; }

template <typename Value>
BsdfValue<Value> evaluate(const MetallicRoughnessBsdf<Value>& bsdf, Vec3f wo, Vec3f wi) {
  if (wi.z <= 0) return {};
  constexpr float kDielectric = 0.04F;  // ((1.5 - 1) / (1.5 + 1))^2
  const Vec3f m = normalised(wo + wi);
  const float cos_o = dot(wo, m);
  const float weight = schlick_weight(cos_o);
  const float dielectric = kDielectric + (1 - kDielectric) * weight;
  const Microfacets facets{.alpha = bsdf.alpha};
  const float diffuse = wi.z * kInvPi;
  const Value metal = bsdf.base * (1 - weight) + even<Value>(weight);
  const Value glossy = metal * bsdf.metallic + even<Value>((1 - bsdf.metallic) * dielectric);
  const float share = facet_share(bsdf.metallic);
  const float facet_cos = facet_density(facets, m) * facet_g2(facets, wo, wi) / (4 * wo.z);
  return {glossy * facet_cos + bsdf.base * ((1 - bsdf.metallic) * (1 - dielectric) * diffuse),
          share * facet_pdf(facets, wo, m) / (4 * cos_o) + (1 - share) * diffuse};
}

template <typename Value>
std::optional<BsdfSample<Value>> sample(const MetallicRoughnessBsdf<Value>& bsdf,
                                        Vec3f wo,
                                        const std::array<float, 4>& u) {
  Vec3f wi = sample_cosine(u[0], u[1]);
  if (u[2] < facet_share(bsdf.metallic)) {
    const Vec3f m = sample_facet({.alpha = bsdf.alpha}, wo, u[0], u[1]);
    wi = m * (2 * dot(wo, m)) - wo;
  }
  const auto value = evaluate(bsdf, wo, wi);
  if (!(value.pdf > 0)) return std::nullopt;
  return BsdfSample<Value>{.wi = wi, .weight = value.f_cos * (1 / value.pdf), .pdf = value.pdf};
}

struct MetallicRoughnessMaterial {
  static constexpr bool kIsAppearance = true;
  template <typename Value, std::size_t N>
  using Bsdfs = BsdfList<MetallicRoughnessBsdf<Value>>;
  TexturedColour base;
  float metallic = 0;
  float alpha = 1;
};

inline MetallicRoughnessMaterial make_material(const scene::MetallicRoughness& m,
                                               const SceneColours& colours) {
  return {make_textured_colour(colours, m.reflectance, m.spectrum, m.texture), static_cast<float>(m.metallic),
          static_cast<float>(alpha_of(m))};
}

inline float lobe_alpha(const MetallicRoughnessMaterial& material) { return material.alpha; }

template <typename Context>
void make_bsdf(typename Context::Bsdf& out, const MetallicRoughnessMaterial& material, const Context& at) {
  out = MetallicRoughnessBsdf<typename Context::Value>{at.reflectance(material.base), material.metallic,
                                                       material.alpha};
}

}  // namespace orbs::tracer

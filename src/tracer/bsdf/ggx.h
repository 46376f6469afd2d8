#pragma once

#include "snippets/ggx.h"
#include "tracer/bsdf/bsdf_sample.h"
#include "tracer/colour/scene_colours.h"
#include "tracer/numeric_fault.h"
#include "tracer/sampling/warps.h"

#include <array>
#include <optional>

namespace orbs::tracer {

/// Height-correlated masking-shadowing G2 of two directions on one side of the surface.
inline float ggx_g2(Vec3f wo, Vec3f wi, float alpha) {
  return snippets::smith_g2_correlated(snippets::ggx_lambda(wo, alpha), snippets::ggx_lambda(wi, alpha));
}

/// snippets::ggx_d.
inline float ggx_density(Vec3f m, float alpha) {
  if (!has_fault(NumericFault::MicrofacetsByCosine)) return snippets::ggx_d(m, alpha);
  const float s = m.z * m.z * (alpha * alpha - 1) + 1;
  return alpha * alpha / (kPi * s * s);
}

/// Glossy reflection without a Fresnel factor: f = colour D G2 / (4 cos cos), height-correlated Smith.
template <typename Value>
struct GgxBsdf {
  static constexpr bool kIsDelta = false;
  static constexpr bool kDepolarises = true;
  static constexpr Event kEvent = Event::Glossy;
  Value colour{};
  float alpha = 0.1F;
};

template <typename Value>
BsdfValue<Value> evaluate(const GgxBsdf<Value>& bsdf, Vec3f wo, Vec3f wi) {
  if (wi.z <= 0) return {};
  const Vec3f m = normalised(wo + wi);
  const float d = ggx_density(m, bsdf.alpha);
  const float f_cos = d * ggx_g2(wo, wi, bsdf.alpha) / (4 * wo.z);
  return {bsdf.colour * f_cos, snippets::ggx_g1(wo, bsdf.alpha) * d / (4 * wo.z)};
}

template <typename Value>
std::optional<BsdfSample<Value>> sample(const GgxBsdf<Value>& bsdf, Vec3f wo, const std::array<float, 4>& u) {
  const Vec3f m = snippets::sample_ggx_visible(wo, bsdf.alpha, sample_disk(u[0], u[1]));
  const Vec3f wi = m * (2 * dot(wo, m)) - wo;
  if (wi.z <= 0) return std::nullopt;  // the microfacet reflects below the horizon: masked
  const float g1 = snippets::ggx_g1(wo, bsdf.alpha);
  return BsdfSample<Value>{.wi = wi,
                           .weight = bsdf.colour * (ggx_g2(wo, wi, bsdf.alpha) / g1),
                           .pdf = g1 * ggx_density(m, bsdf.alpha) / (4 * wo.z)};
}

struct GgxMaterial {
  static constexpr bool kIsAppearance = false;
  template <typename Value, std::size_t N>
  using Bsdfs = BsdfList<GgxBsdf<Value>>;
  Colour colour;
  float alpha = 0;
};

inline GgxMaterial make_material(const scene::Ggx& m, const SceneColours& colours) {
  return {make_colour(colours, m.colour, m.spectrum), static_cast<float>(m.alpha)};
}

inline float lobe_alpha(const GgxMaterial& material) { return material.alpha; }

template <typename Context>
void make_bsdf(typename Context::Bsdf& out, const GgxMaterial& material, const Context& at) {
  out = GgxBsdf<typename Context::Value>{at.reflectance(material.colour), material.alpha};
}

}  // namespace orbs::tracer

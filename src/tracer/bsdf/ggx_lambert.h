#pragma once

#include "tracer/bsdf/broadcast.h"
#include "tracer/bsdf/ggx.h"

#include <array>
#include <optional>

namespace orbs::tracer {

/// The sum of ggx and Lambert's law, whose colours are at most 1 together. Light is depolarised.
template <typename Value>
struct GgxLambertBsdf {
  static constexpr bool kIsDelta = false;
  static constexpr bool kDepolarises = true;
  static constexpr Event kEvent = Event::Glossy;
  GgxBsdf<Value> glossy;
  Value diffuse{};
  float glossy_share = 0.5F;  // of the samples
};

template <typename Value>
BsdfValue<Value> evaluate(const GgxLambertBsdf<Value>& bsdf, Vec3f wo, Vec3f wi) {
  if (wi.z <= 0) return {};
  const auto facets = evaluate(bsdf.glossy, wo, wi);
  const float diffuse = wi.z * kInvPi;
  return {facets.f_cos + bsdf.diffuse * diffuse,
          bsdf.glossy_share * facets.pdf + (1 - bsdf.glossy_share) * diffuse};
}

template <typename Value>
std::optional<BsdfSample<Value>> sample(const GgxLambertBsdf<Value>& bsdf,
                                        Vec3f wo,
                                        const std::array<float, 4>& u) {
  Vec3f wi = sample_cosine(u[0], u[1]);
  if (u[2] < bsdf.glossy_share) {
    const Vec3f m = snippets::sample_ggx_visible(wo, bsdf.glossy.alpha, sample_disk(u[0], u[1]));
    wi = m * (2 * dot(wo, m)) - wo;
  }
  const auto value = evaluate(bsdf, wo, wi);
  if (!(value.pdf > 0)) return std::nullopt;
  return BsdfSample<Value>{.wi = wi, .weight = value.f_cos * (1 / value.pdf), .pdf = value.pdf};
}

struct GgxLambertMaterial {
  static constexpr bool kIsAppearance = true;
  template <typename Value, std::size_t N>
  using Bsdfs = BsdfList<GgxLambertBsdf<Value>>;
  Colour glossy;
  float alpha = 0;
  Colour diffuse;
};

inline GgxLambertMaterial make_material(const scene::GgxLambert& m, const SceneColours& colours) {
  const auto [glossy, diffuse] = mixed_colours(m);
  return {make_colour(colours, glossy), static_cast<float>(m.alpha), make_colour(colours, diffuse)};
}

inline float lobe_alpha(const GgxLambertMaterial& material) { return material.alpha; }

template <typename Context>
void make_bsdf(typename Context::Bsdf& out, const GgxLambertMaterial& material, const Context& at) {
  using Value = typename Context::Value;
  const Value glossy = at.reflectance(material.glossy);
  const Value diffuse = at.reflectance(material.diffuse);
  const float sum = mean_of(glossy) + mean_of(diffuse);
  out = GgxLambertBsdf<Value>{{glossy, material.alpha}, diffuse, sum > 0 ? mean_of(glossy) / sum : 0.5F};
}

}  // namespace orbs::tracer

#pragma once

#include "tracer/bsdf/broadcast.h"
#include "tracer/bsdf/ggx.h"

#include <array>
#include <optional>

namespace orbs::tracer {

/// Schlick's weight (1 - cos)^5 of what reflects everything at grazing angles (Schlick 1994, eq. 15).
inline float schlick_weight(float cosine) {
  const float x = 1 - cosine;
  return x * x * x * x * x;
}

/// Glossy reflection of ggx times Schlick's Fresnel factor at the microfacet. Light is depolarised: the
/// factor says nothing of polarisation.
template <typename Value>
struct MetalBsdf {
  static constexpr bool kIsDelta = false;
  static constexpr bool kDepolarises = true;
  static constexpr Event kEvent = Event::Glossy;
  Value reflectance{};
  float alpha = 0.1F;
};

template <typename Value>
Value schlick(Value reflectance, float cosine) {
  const float weight = schlick_weight(cosine);
  return reflectance * (1 - weight) + even<Value>(weight);
}

template <typename Value>
BsdfValue<Value> evaluate(const MetalBsdf<Value>& bsdf, Vec3f wo, Vec3f wi) {
  const auto white = evaluate(GgxBsdf<Value>{even<Value>(1), bsdf.alpha}, wo, wi);
  if (!(white.pdf > 0)) return {};
  return {white.f_cos * schlick(bsdf.reflectance, dot(wo, normalised(wo + wi))), white.pdf};
}

template <typename Value>
std::optional<BsdfSample<Value>> sample(const MetalBsdf<Value>& bsdf,
                                        Vec3f wo,
                                        const std::array<float, 4>& u) {
  auto out = sample(GgxBsdf<Value>{even<Value>(1), bsdf.alpha}, wo, u);
  if (out) out->weight = out->weight * schlick(bsdf.reflectance, dot(wo, normalised(wo + out->wi)));
  return out;
}

struct MetalMaterial {
  static constexpr bool kIsAppearance = true;
  template <typename Value, std::size_t N>
  using Bsdfs = BsdfList<MetalBsdf<Value>>;
  Colour reflectance;
  float alpha = 0;
};

inline MetalMaterial make_material(const scene::Metal& m, const SceneColours& colours) {
  return {make_colour(colours, m.reflectance, m.spectrum), static_cast<float>(m.alpha)};
}

inline float lobe_alpha(const MetalMaterial& material) { return material.alpha; }

template <typename Context>
void make_bsdf(typename Context::Bsdf& out, const MetalMaterial& material, const Context& at) {
  out = MetalBsdf<typename Context::Value>{at.reflectance(material.reflectance), material.alpha};
}

}  // namespace orbs::tracer

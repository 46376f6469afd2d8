#pragma once

#include "tracer/bsdf/bsdf_sample.h"
#include "tracer/colour/scene_colours.h"
#include "tracer/sampling/warps.h"

#include <array>
#include <optional>

namespace orbs::tracer {

/// ORB.S eq. 5 (Oren and Nayar 1994, the short form without interreflection). The specification prints
/// cos(theta_i - theta_r) where the paper has the azimuths; we take the azimuths.
template <typename Value>
struct OrenNayarBsdf {
  static constexpr bool kIsDelta = false;
  static constexpr bool kDepolarises = true;
  static constexpr Event kEvent = Event::Diffuse;
  Value reflectance{};
  float a = 1;
  float b = 0;
};

/// `roughness` in [0, 1]; the paper's sigma is roughness * pi / 2.
template <typename Value>
OrenNayarBsdf<Value> make_oren_nayar(const Value& reflectance, float roughness) {
  const float sigma = roughness * kPi / 2;
  const float s2 = sigma * sigma;
  return {reflectance, 1 - 0.5F * s2 / (s2 + 0.33F), 0.45F * s2 / (s2 + 0.09F)};
}

/// A + B max(0, cos(phi_i - phi_r)) sin(alpha) tan(beta), with alpha the larger and beta the smaller angle to
/// the normal: sin(alpha) tan(beta) = sin sin / max(cos, cos).
template <typename Value>
float oren_nayar_factor(const OrenNayarBsdf<Value>& bsdf, Vec3f wo, Vec3f wi) {
  const float sin_sin_cos_phi = wo.x * wi.x + wo.y * wi.y;
  if (sin_sin_cos_phi <= 0) return bsdf.a;
  return bsdf.a + bsdf.b * sin_sin_cos_phi / std::max(wo.z, wi.z);
}

template <typename Value>
BsdfValue<Value> evaluate(const OrenNayarBsdf<Value>& bsdf, Vec3f wo, Vec3f wi) {
  if (wi.z <= 0) return {};
  const float pdf = wi.z * kInvPi;
  return {bsdf.reflectance * (oren_nayar_factor(bsdf, wo, wi) * pdf), pdf};
}

template <typename Value>
std::optional<BsdfSample<Value>> sample(const OrenNayarBsdf<Value>& bsdf,
                                        Vec3f wo,
                                        const std::array<float, 4>& u) {
  const Vec3f wi = sample_cosine(u[0], u[1]);
  if (wi.z <= 0) return std::nullopt;
  return BsdfSample<Value>{
      .wi = wi, .weight = bsdf.reflectance * oren_nayar_factor(bsdf, wo, wi), .pdf = wi.z * kInvPi};
}

struct OrenNayarMaterial {
  static constexpr bool kIsAppearance = false;
  template <typename Value, std::size_t N>
  using Bsdfs = BsdfList<OrenNayarBsdf<Value>>;
  TexturedColour reflectance;
  float roughness = 0;
};

inline OrenNayarMaterial make_material(const scene::OrenNayar& m, const SceneColours& colours) {
  return {make_textured_colour(colours, m.reflectance, m.spectrum, m.texture),
          static_cast<float>(m.roughness)};
}

inline float lobe_alpha(const OrenNayarMaterial&) { return kNoLobe; }

template <typename Context>
void make_bsdf(typename Context::Bsdf& out, const OrenNayarMaterial& material, const Context& at) {
  out = make_oren_nayar(at.reflectance(material.reflectance), material.roughness);
}

}  // namespace orbs::tracer

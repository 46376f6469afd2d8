#pragma once

#include "tracer/bsdf/broadcast.h"
#include "tracer/bsdf/fresnel.h"
#include "tracer/bsdf/microfacets.h"
#include "tracer/bsdf/plastic_coat.h"
#include "tracer/colour/scene_colours.h"

#include <array>
#include <optional>

namespace orbs::tracer {

/// The diffuse part of plastic, f = base T(wo) T(wi) / pi with what the coat lets through, as
/// SmoothPlasticBsdf and RoughPlasticBsdf share it. `base` is reflectance / (1 - q) / eta^2, where q is what
/// the coat reflects inside, times the reflectance if that is nonlinear. Light is depolarised.
template <typename Value>
struct PlasticBase {
  static constexpr bool kIsDelta = false;
  static constexpr bool kDepolarises = true;
  static constexpr Event kEvent = Event::Glossy;
  Value base{};
  /// About what the base sends out of all that enters: samples are shared by it.
  float brightness = 0;
};

/// The share of samples that the boundary gets when it reflects the part `reflected`.
inline float boundary_share(float reflected, float brightness) {
  const float sum = reflected + (1 - reflected) * brightness;
  return sum > 0 ? reflected / sum : 0;
}

/// Under a smooth coat: a mirror by Fresnel's formula and the base. The mirror is a delta function, which
/// evaluate() and its pdf leave out.
template <typename Value>
struct SmoothPlasticBsdf : PlasticBase<Value> {
  float eta = 1.5F;
};

template <typename Value>
BsdfValue<Value> evaluate(const SmoothPlasticBsdf<Value>& bsdf, Vec3f wo, Vec3f wi) {
  if (wi.z <= 0) return {};
  const float reflected = fresnel_dielectric(wo.z, bsdf.eta);
  const float diffuse = wi.z * kInvPi;
  return {bsdf.base * ((1 - reflected) * (1 - fresnel_dielectric(wi.z, bsdf.eta)) * diffuse),
          (1 - boundary_share(reflected, bsdf.brightness)) * diffuse};
}

template <typename Value>
std::optional<BsdfSample<Value>> sample(const SmoothPlasticBsdf<Value>& bsdf,
                                        Vec3f wo,
                                        const std::array<float, 4>& u) {
  const float reflected = fresnel_dielectric(wo.z, bsdf.eta);
  const float share = boundary_share(reflected, bsdf.brightness);
  // A pdf of 0 says that light sampling could not have found this direction.
  if (u[2] < share)
    return BsdfSample<Value>{.wi = {-wo.x, -wo.y, wo.z}, .weight = even<Value>(reflected / share), .pdf = 0};
  const Vec3f wi = sample_cosine(u[0], u[1]);
  const auto value = evaluate(bsdf, wo, wi);
  if (!(value.pdf > 0)) return std::nullopt;
  return BsdfSample<Value>{.wi = wi, .weight = value.f_cos * (1 / value.pdf), .pdf = value.pdf};
}

/// Under a rough coat: F D G / (4 cos cos) of microfacets and the base.
template <typename Value>
struct RoughPlasticBsdf : PlasticBase<Value> {
  float eta = 1.5F;
  Microfacets facets;
  const float* entering = nullptr;  // PlasticCoat::entering
};

template <typename Value>
BsdfValue<Value> evaluate(const RoughPlasticBsdf<Value>& bsdf, Vec3f wo, Vec3f wi) {
  if (wi.z <= 0) return {};
  const Vec3f m = normalised(wo + wi);
  const float cos_o = std::min(dot(wo, m), 1.0F);  // rounding only: both are unit vectors
  const float facet_cos = fresnel_dielectric(cos_o, bsdf.eta) * facet_density(bsdf.facets, m) *
                          facet_g2(bsdf.facets, wo, wi) / (4 * wo.z);
  const float entered = entering_rough(bsdf.entering, wo.z);
  const float diffuse = wi.z * kInvPi;
  const float share = boundary_share(1 - entered, bsdf.brightness);
  return {bsdf.base * (entered * entering_rough(bsdf.entering, wi.z) * diffuse) + even<Value>(facet_cos),
          share * facet_pdf(bsdf.facets, wo, m) / (4 * cos_o) + (1 - share) * diffuse};
}

template <typename Value>
std::optional<BsdfSample<Value>> sample(const RoughPlasticBsdf<Value>& bsdf,
                                        Vec3f wo,
                                        const std::array<float, 4>& u) {
  Vec3f wi = sample_cosine(u[0], u[1]);
  if (u[2] < boundary_share(1 - entering_rough(bsdf.entering, wo.z), bsdf.brightness)) {
    const Vec3f m = sample_facet(bsdf.facets, wo, u[0], u[1]);
    wi = m * (2 * dot(wo, m)) - wo;
  }
  const auto value = evaluate(bsdf, wo, wi);
  if (!(value.pdf > 0)) return std::nullopt;
  return BsdfSample<Value>{.wi = wi, .weight = value.f_cos * (1 / value.pdf), .pdf = value.pdf};
}

struct PlasticMaterial {
  static constexpr bool kIsAppearance = true;
  template <typename Value, std::size_t N>
  using Bsdfs = BsdfList<SmoothPlasticBsdf<Value>, RoughPlasticBsdf<Value>>;
  TexturedColour reflectance;
  bool is_nonlinear = false;
  PlasticCoat coat;
};

inline PlasticMaterial make_material(const scene::Plastic& m, const SceneColours& colours) {
  return {make_textured_colour(colours, m.reflectance, m.spectrum, m.texture), m.is_nonlinear,
          make_coat(static_cast<float>(m.ior), static_cast<float>(m.alpha.value_or(0)))};
}

/// The mirror of a smooth coat is as narrow as a lobe can be, but it is not all that the material has.
inline float lobe_alpha(const PlasticMaterial& material) {
  return material.coat.alpha > 0 ? material.coat.alpha : kPartlyDelta;
}

template <typename Value>
PlasticBase<Value> plastic_base(const PlasticMaterial& material, const Value& reflectance) {
  const PlasticCoat& coat = material.coat;
  const float leaving = 1 - coat.reflected_inside;
  const Value kept =
      material.is_nonlinear ? even<Value>(1) - reflectance * coat.reflected_inside : even<Value>(leaving);
  const Value out = quotient(reflectance, kept);
  return {out * (1 / (coat.eta * coat.eta)), leaving * mean_of(out)};
}

template <typename Context>
void make_bsdf(typename Context::Bsdf& out, const PlasticMaterial& material, const Context& at) {
  using Value = typename Context::Value;
  const auto base = plastic_base(material, at.reflectance(material.reflectance));
  const PlasticCoat& coat = material.coat;
  if (coat.alpha > 0)
    out = RoughPlasticBsdf<Value>{base, coat.eta, {.alpha = coat.alpha}, coat.entering.data()};
  else
    out = SmoothPlasticBsdf<Value>{base, coat.eta};
}

}  // namespace orbs::tracer

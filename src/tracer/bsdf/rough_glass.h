#pragma once

#include "snippets/ggx.h"
#include "tracer/bsdf/bsdf_sample.h"
#include "tracer/bsdf/fresnel.h"
#include "tracer/bsdf/ggx.h"
#include "tracer/bsdf/polarisation.h"
#include "tracer/colour/scene_colours.h"
#include "tracer/sampling/warps.h"

#include <array>
#include <optional>

namespace orbs::tracer {

/// Rough dielectric of Walter et al. 2007 (eq. 20 and 21) with GGX. Reflection uses height-correlated
/// masking; in transmission the two directions are on opposite sides of the microsurface, for which the
/// separable product G1 G1 (Walter eq. 23) is the usual model. `eta` is the index beyond the surface over the
/// index on the viewer's side.
template <typename Value>
struct RoughGlassBsdf {
  static constexpr bool kIsDelta = false;
  static constexpr bool kDepolarises = false;
  static constexpr Event kEvent = Event::Glossy;
  Value colour{};
  float eta = 1;
  float alpha = 0.1F;
};

template <typename Value>
BsdfValue<Value> evaluate(const RoughGlassBsdf<Value>& bsdf, Vec3f wo, Vec3f wi) {
  const auto m = facet_between(wo, wi, bsdf.eta);
  if (!m) return {};
  const float cos_o = dot(wo, *m);
  const float fresnel = fresnel_dielectric(cos_o, bsdf.eta);
  const float d = snippets::ggx_d(*m, bsdf.alpha);
  const float visible = snippets::ggx_g1(wo, bsdf.alpha) * cos_o * d / wo.z;
  if (wi.z > 0) {
    const float f_cos = fresnel * d * ggx_g2(wo, wi, bsdf.alpha) / (4 * wo.z);
    return {bsdf.colour * f_cos, fresnel * visible / (4 * cos_o)};
  }
  const float pdf = (1 - fresnel) * visible * refraction_jacobian(cos_o, dot(wi, *m), bsdf.eta);
  return {bsdf.colour * (pdf * snippets::ggx_g1(wi, bsdf.alpha) / (bsdf.eta * bsdf.eta)), pdf};
}

template <typename Value>
std::optional<BsdfSample<Value>> sample(const RoughGlassBsdf<Value>& bsdf,
                                        Vec3f wo,
                                        const std::array<float, 4>& u) {
  const Vec3f m = snippets::sample_ggx_visible(wo, bsdf.alpha, sample_disk(u[0], u[1]));
  const float cos_o = dot(wo, m);
  if (cos_o <= 0) return std::nullopt;
  const float fresnel = fresnel_dielectric(cos_o, bsdf.eta);
  BsdfSample<Value> out;
  if (u[2] < fresnel) {
    out.wi = m * (2 * cos_o) - wo;
    if (out.wi.z <= 0) return std::nullopt;
    out.weight = bsdf.colour * (ggx_g2(wo, out.wi, bsdf.alpha) / snippets::ggx_g1(wo, bsdf.alpha));
    out.pdf = fresnel * snippets::ggx_visible_d(wo, m, bsdf.alpha) / (4 * cos_o);
    return out;
  }
  const auto wi = refracted_at_facet(wo, m, bsdf.eta);
  if (!wi || wi->z >= 0) return std::nullopt;
  out.wi = *wi;
  out.is_transmitted = true;
  out.radiance_scale = 1 / (bsdf.eta * bsdf.eta);
  out.weight = bsdf.colour * (snippets::ggx_g1(*wi, bsdf.alpha) * out.radiance_scale);
  if (const auto rounded = facet_as_rounded(wo, *wi, m, bsdf.eta))
    out.pdf = (1 - fresnel) * snippets::ggx_visible_d(wo, *rounded, bsdf.alpha) *
              refraction_jacobian(dot(wo, *rounded), dot(*wi, *rounded), bsdf.eta);
  return out;
}

template <typename Value>
std::optional<Polarisation> polarisation_by(const RoughGlassBsdf<Value>& bsdf, const auto& scattering) {
  return facet_polarisation_between(boundary_of(bsdf.eta), scattering);
}

struct RoughGlassMaterial {
  static constexpr bool kIsAppearance = false;
  template <typename Value, std::size_t N>
  using Bsdfs = BsdfList<RoughGlassBsdf<Value>>;
  Colour colour;
  float ior = 1;  // inside over outside
  float alpha = 0;
};

inline RoughGlassMaterial make_material(const scene::RoughGlass& m, const SceneColours& colours) {
  return {make_colour(colours, m.colour), static_cast<float>(m.ior), static_cast<float>(m.alpha)};
}

inline float lobe_alpha(const RoughGlassMaterial& material) { return material.alpha; }

template <typename Context>
void make_bsdf(typename Context::Bsdf& out, const RoughGlassMaterial& material, const Context& at) {
  out = RoughGlassBsdf<typename Context::Value>{
      at.reflectance(material.colour), at.is_outside ? material.ior : 1 / material.ior, material.alpha};
}

}  // namespace orbs::tracer

#pragma once

#include "scene/effects/effects.h"
#include "tracer/bsdf/boundary_bsdf.h"
#include "tracer/bsdf/broadcast.h"
#include "tracer/bsdf/bsdf_sample.h"
#include "tracer/bsdf/fresnel.h"
#include "tracer/bsdf/microfacets.h"
#include "tracer/bsdf/polarisation.h"
#include "tracer/colour/scene_colours.h"

#include <array>
#include <optional>

/// Dielectric boundaries by their indices of refraction. All wavelengths of a path take the direction of the
/// hero wavelength; where their directions differ, make_bsdf terminates the secondary wavelengths first.
/// Reflection is chosen with the mean reflectance of the wavelengths as its probability, so that no weight
/// exceeds their number.
namespace orbs::tracer {

template <typename Value, std::size_t N>
struct DielectricBsdf : SmoothBoundaryBsdf<Value, N> {};

template <typename Value, std::size_t N>
std::optional<BsdfSample<Value>> sample(const DielectricBsdf<Value, N>& bsdf,
                                        Vec3f wo,
                                        const std::array<float, 4>& u) {
  const auto reflected = reflectances(bsdf.boundary, wo.z);
  const float probability = mean_of(reflected);
  BsdfSample<Value> out;
  if (u[2] < probability) {
    out.wi = {-wo.x, -wo.y, wo.z};
    out.weight = broadcast<Value>(reflected) * (1 / probability);
    return out;
  }
  const float eta = bsdf.boundary.index[0].real();
  const auto wi = refracted(wo, {0, 0, 1}, eta);
  if (!wi) return std::nullopt;  // at grazing angles rounding can take Fresnel's term below 1
  out.wi = *wi;
  out.is_transmitted = true;
  out.radiance_scale = 1 / (eta * eta);
  out.weight = broadcast<Value>(one_minus(reflected)) * (out.radiance_scale / (1 - probability));
  return out;
}

/// Walter et al. 2007, eq. 20 and 21, with the same masking-shadowing model for reflection and transmission.
template <typename Value, std::size_t N>
struct RoughDielectricBsdf : RoughBoundaryBsdf<Value, N> {};

template <typename Value, std::size_t N>
BsdfValue<Value> evaluate(const RoughDielectricBsdf<Value, N>& bsdf, Vec3f wo, Vec3f wi) {
  const float eta = bsdf.boundary.index[0].real();
  const auto m = facet_between(wo, wi, eta);
  if (!m) return {};
  const float cos_o = dot(wo, *m);
  const auto reflected = reflectances(bsdf.boundary, cos_o);
  const float probability = mean_of(reflected);
  const float visible = facet_pdf(bsdf.facets, wo, *m);
  // G2 D cos_o / wo.z over the pdf of the microfacet, in the same form as the weight of sample().
  const float seen =
      facet_g2(bsdf.facets, wo, wi) / snippets::smith_g1(facet_lambda(bsdf.facets, wo)) * visible;
  if (wi.z > 0)
    return {broadcast<Value>(reflected) * (seen / (4 * cos_o)), probability * visible / (4 * cos_o)};
  const float jacobian = refraction_jacobian(cos_o, dot(wi, *m), eta);
  return {broadcast<Value>(one_minus(reflected)) * (seen * jacobian / (eta * eta)),
          (1 - probability) * visible * jacobian};
}

template <typename Value, std::size_t N>
std::optional<BsdfSample<Value>> sample(const RoughDielectricBsdf<Value, N>& bsdf,
                                        Vec3f wo,
                                        const std::array<float, 4>& u) {
  const Vec3f m = sample_facet(bsdf.facets, wo, u[0], u[1]);
  const float cos_o = dot(wo, m);
  if (cos_o <= 0) return std::nullopt;
  const auto reflected = reflectances(bsdf.boundary, cos_o);
  const float probability = mean_of(reflected);
  const float g1 = snippets::smith_g1(facet_lambda(bsdf.facets, wo));
  BsdfSample<Value> out;
  if (u[2] < probability) {
    out.wi = m * (2 * cos_o) - wo;
    if (out.wi.z <= 0) return std::nullopt;
    out.weight = broadcast<Value>(reflected) * (facet_g2(bsdf.facets, wo, out.wi) / (g1 * probability));
    out.pdf = probability * facet_pdf(bsdf.facets, wo, m) / (4 * cos_o);
    return out;
  }
  const float eta = bsdf.boundary.index[0].real();
  const auto wi = refracted_at_facet(wo, m, eta);
  if (!wi || wi->z >= 0) return std::nullopt;
  out.wi = *wi;
  out.is_transmitted = true;
  out.radiance_scale = 1 / (eta * eta);
  out.weight = broadcast<Value>(one_minus(reflected)) *
               (facet_g2(bsdf.facets, wo, *wi) * out.radiance_scale / (g1 * (1 - probability)));
  if (const auto rounded = facet_as_rounded(wo, *wi, m, eta))
    out.pdf = (1 - probability) * facet_pdf(bsdf.facets, wo, *rounded) *
              refraction_jacobian(dot(wo, *rounded), dot(*wi, *rounded), eta);
  return out;
}

template <typename Value, std::size_t N>
std::optional<Polarisation> polarisation_by(const RoughDielectricBsdf<Value, N>& bsdf,
                                            const auto& scattering) {
  return facet_polarisation_between(bsdf.boundary, scattering);
}

struct DielectricMaterial {
  static constexpr bool kIsAppearance = true;
  template <typename Value, std::size_t N>
  using Bsdfs = BsdfList<DielectricBsdf<Value, N>, RoughDielectricBsdf<Value, N>>;
  scene::Dielectric glass;
  bool is_dispersive = false;
};

inline DielectricMaterial make_material(const scene::Dielectric& m, const SceneColours&) {
  return {m, scene::is_dispersive(m)};
}

inline float lobe_alpha(const DielectricMaterial& material) { return lobe_alpha(material.glass.roughness); }

template <typename Context>
void make_bsdf(typename Context::Bsdf& out, const DielectricMaterial& material, const Context& at) {
  using Value = typename Context::Value;
  constexpr auto kN = Context::kWavelengths;
  if (material.is_dispersive) at.terminate_secondary();
  const scene::Dielectric& glass = material.glass;
  const auto& here = at.is_outside ? glass.outside : glass.index;
  const auto& beyond = at.is_outside ? glass.index : glass.outside;
  const auto boundary = boundary_between<kN>(at.wavelengths_nm(), here, beyond, glass.film);
  if (glass.roughness)
    out = RoughDielectricBsdf<Value, kN>{{boundary, microfacets(*glass.roughness)}};
  else
    out = DielectricBsdf<Value, kN>{{boundary}};
}

}  // namespace orbs::tracer

#pragma once

#include "tracer/scatter/bsdf_sample.h"
#include "tracer/scatter/interface.h"
#include "tracer/scatter/microfacets.h"
#include "tracer/scatter/refraction.h"
#include "tracer/scatter/value_of.h"

#include <array>
#include <optional>

/// Both sides of glass and its like. Light of all wavelengths takes the direction of the first: where they
/// differ, the path has dropped the others before (place_bsdf). Whether it is reflected is decided by the
/// mean reflectance of the wavelengths, so that no weight exceeds their number.
namespace orbs::tracer {

template <typename Value, std::size_t N>
struct DielectricBsdf {
  static constexpr bool kIsDelta = true;
  static constexpr Event kEvent = Event::Specular;
  Interface<N> interface;
};

template <typename Value, std::size_t N>
BsdfValue<Value> evaluate(const DielectricBsdf<Value, N>&, Vec3f, Vec3f) {
  return {};
}

template <typename Value, std::size_t N>
std::optional<BsdfSample<Value>> sample(const DielectricBsdf<Value, N>& bsdf,
                                        Vec3f wo,
                                        const std::array<float, 4>& u) {
  const auto reflected = reflectances(bsdf.interface, wo.z);
  const float chance = mean_of(reflected);
  BsdfSample<Value> out;
  if (u[2] < chance) {
    out.wi = {-wo.x, -wo.y, wo.z};
    out.weight = value_of<Value>(reflected) * (1 / chance);
    return out;
  }
  const float eta = bsdf.interface.index[0].real();
  const auto wi = refracted(wo, {0, 0, 1}, eta);
  if (!wi) return std::nullopt;  // grazing by rounding: Fresnel said less than total reflection
  out.wi = *wi;
  out.is_transmitted = true;
  out.radiance_scale = 1 / (eta * eta);
  out.weight = value_of<Value>(rest_of(reflected)) * (out.radiance_scale / (1 - chance));
  return out;
}

/// Walter et al. 2007, eq. 20 and 21, with one kind of masking for both reflection and transmission.
template <typename Value, std::size_t N>
struct RoughDielectricBsdf {
  static constexpr bool kIsDelta = false;
  static constexpr Event kEvent = Event::Glossy;
  Interface<N> interface;
  Microfacets facets;
};

template <typename Value, std::size_t N>
BsdfValue<Value> evaluate(const RoughDielectricBsdf<Value, N>& bsdf, Vec3f wo, Vec3f wi) {
  const float eta = bsdf.interface.index[0].real();
  const auto m = facet_between(wo, wi, eta);
  if (!m) return {};
  const float cos_o = dot(wo, *m);
  const auto reflected = reflectances(bsdf.interface, cos_o);
  const float chance = mean_of(reflected);
  const float visible = facet_pdf(bsdf.facets, wo, *m);
  // G2 D cos_o / (wo.z) over the density of the facet: what sample() has for a weight, too.
  const float seen =
      facet_g2(bsdf.facets, wo, wi) / snippets::smith_g1(facet_lambda(bsdf.facets, wo)) * visible;
  if (wi.z > 0) return {value_of<Value>(reflected) * (seen / (4 * cos_o)), chance * visible / (4 * cos_o)};
  const float jacobian = refraction_jacobian(cos_o, dot(wi, *m), eta);
  return {value_of<Value>(rest_of(reflected)) * (seen * jacobian / (eta * eta)),
          (1 - chance) * visible * jacobian};
}

template <typename Value, std::size_t N>
std::optional<BsdfSample<Value>> sample(const RoughDielectricBsdf<Value, N>& bsdf,
                                        Vec3f wo,
                                        const std::array<float, 4>& u) {
  const Vec3f m = sample_facet(bsdf.facets, wo, u[0], u[1]);
  const float cos_o = dot(wo, m);
  if (cos_o <= 0) return std::nullopt;
  const auto reflected = reflectances(bsdf.interface, cos_o);
  const float chance = mean_of(reflected);
  const float visible = facet_pdf(bsdf.facets, wo, m);
  const float g1 = snippets::smith_g1(facet_lambda(bsdf.facets, wo));
  BsdfSample<Value> out;
  if (u[2] < chance) {
    out.wi = m * (2 * cos_o) - wo;
    if (out.wi.z <= 0) return std::nullopt;
    out.weight = value_of<Value>(reflected) * (facet_g2(bsdf.facets, wo, out.wi) / (g1 * chance));
    out.pdf = chance * visible / (4 * cos_o);
    return out;
  }
  const float eta = bsdf.interface.index[0].real();
  const auto wi = refracted(wo, m, eta);
  if (!wi || wi->z >= 0) return std::nullopt;
  out.wi = *wi;
  out.is_transmitted = true;
  out.radiance_scale = 1 / (eta * eta);
  out.weight = value_of<Value>(rest_of(reflected)) *
               (facet_g2(bsdf.facets, wo, *wi) * out.radiance_scale / (g1 * (1 - chance)));
  out.pdf = (1 - chance) * visible * refraction_jacobian(cos_o, dot(*wi, m), eta);
  return out;
}

}  // namespace orbs::tracer

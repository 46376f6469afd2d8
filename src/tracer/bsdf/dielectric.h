#pragma once

#include "tracer/bsdf/bsdf_sample.h"
#include "tracer/bsdf/boundary.h"
#include "tracer/bsdf/microfacets.h"
#include "tracer/bsdf/refraction.h"
#include "tracer/bsdf/broadcast.h"

#include <array>
#include <optional>

/// Both sides of glass and its like. Light of all wavelengths takes the direction of the first: where they
/// differ, the path has dropped the others before (make_bsdf). Whether it is reflected is decided by the
/// mean reflectance of the wavelengths, so that no weight exceeds their number.
namespace orbs::tracer {

template <typename Value, std::size_t N>
struct DielectricBsdf {
  static constexpr bool kIsDelta = true;
  static constexpr Event kEvent = Event::Specular;
  Boundary<N> boundary;
};

template <typename Value, std::size_t N>
BsdfValue<Value> evaluate(const DielectricBsdf<Value, N>&, Vec3f, Vec3f) {
  return {};
}

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
  if (!wi) return std::nullopt;  // grazing by rounding: Fresnel said less than total reflection
  out.wi = *wi;
  out.is_transmitted = true;
  out.radiance_scale = 1 / (eta * eta);
  out.weight = broadcast<Value>(one_minus(reflected)) * (out.radiance_scale / (1 - probability));
  return out;
}

/// Walter et al. 2007, eq. 20 and 21, with one kind of masking for both reflection and transmission.
template <typename Value, std::size_t N>
struct RoughDielectricBsdf {
  static constexpr bool kIsDelta = false;
  static constexpr Event kEvent = Event::Glossy;
  Boundary<N> boundary;
  Microfacets facets;
};

template <typename Value, std::size_t N>
BsdfValue<Value> evaluate(const RoughDielectricBsdf<Value, N>& bsdf, Vec3f wo, Vec3f wi) {
  const float eta = bsdf.boundary.index[0].real();
  const auto m = facet_between(wo, wi, eta);
  if (!m) return {};
  const float cos_o = dot(wo, *m);
  const auto reflected = reflectances(bsdf.boundary, cos_o);
  const float probability = mean_of(reflected);
  const float visible = facet_pdf(bsdf.facets, wo, *m);
  // G2 D cos_o / (wo.z) over the density of the facet: what sample() has for a weight, too.
  const float seen =
      facet_g2(bsdf.facets, wo, wi) / snippets::smith_g1(facet_lambda(bsdf.facets, wo)) * visible;
  if (wi.z > 0) return {broadcast<Value>(reflected) * (seen / (4 * cos_o)), probability * visible / (4 * cos_o)};
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
  const float visible = facet_pdf(bsdf.facets, wo, m);
  const float g1 = snippets::smith_g1(facet_lambda(bsdf.facets, wo));
  BsdfSample<Value> out;
  if (u[2] < probability) {
    out.wi = m * (2 * cos_o) - wo;
    if (out.wi.z <= 0) return std::nullopt;
    out.weight = broadcast<Value>(reflected) * (facet_g2(bsdf.facets, wo, out.wi) / (g1 * probability));
    out.pdf = probability * visible / (4 * cos_o);
    return out;
  }
  const float eta = bsdf.boundary.index[0].real();
  const auto wi = refracted(wo, m, eta);
  if (!wi || wi->z >= 0) return std::nullopt;
  out.wi = *wi;
  out.is_transmitted = true;
  out.radiance_scale = 1 / (eta * eta);
  out.weight = broadcast<Value>(one_minus(reflected)) *
               (facet_g2(bsdf.facets, wo, *wi) * out.radiance_scale / (g1 * (1 - probability)));
  out.pdf = (1 - probability) * visible * refraction_jacobian(cos_o, dot(*wi, m), eta);
  return out;
}

}  // namespace orbs::tracer

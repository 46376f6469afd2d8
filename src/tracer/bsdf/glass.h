#pragma once

#include "tracer/bsdf/bsdf_sample.h"
#include "tracer/bsdf/fresnel.h"
#include "tracer/bsdf/polarisation.h"
#include "tracer/colour/scene_colours.h"

#include <array>
#include <optional>

namespace orbs::tracer {

/// ORB.S REQ_M8: reflection or refraction, chosen by the Fresnel reflectance. `eta` is the index beyond the
/// surface over the index on the viewer's side. Radiance is scaled by eta^2 on entering the denser medium
/// (Veach 1997, 5.2), hence by 1 / eta^2 on a path from the camera.
template <typename Value>
struct GlassBsdf {
  static constexpr bool kIsDelta = true;
  static constexpr bool kDepolarises = false;
  static constexpr Event kEvent = Event::Specular;
  Value colour{};
  float eta = 1;
};

template <typename Value>
BsdfValue<Value> evaluate(const GlassBsdf<Value>&, Vec3f, Vec3f) {
  return {};
}

template <typename Value>
std::optional<BsdfSample<Value>> sample(const GlassBsdf<Value>& bsdf,
                                        Vec3f wo,
                                        const std::array<float, 4>& u) {
  BsdfSample<Value> out{.weight = bsdf.colour};
  if (u[2] < fresnel_dielectric(wo.z, bsdf.eta)) {
    out.wi = {-wo.x, -wo.y, wo.z};
    return out;
  }
  constexpr float kNearOne = 1e-3F;
  if (has_fault(NumericFault::NearIndexIgnored) && bsdf.eta != 1 && std::abs(bsdf.eta - 1) < kNearOne)
    return std::nullopt;
  const auto wi = refracted(wo, {0, 0, 1}, bsdf.eta);
  if (!wi) return std::nullopt;  // at grazing angles rounding can take Fresnel's term below 1
  out.wi = *wi;
  out.is_transmitted = true;
  out.radiance_scale = 1 / (bsdf.eta * bsdf.eta);
  out.weight = bsdf.colour * out.radiance_scale;
  return out;
}

template <typename Value>
std::optional<Polarisation> polarisation_by(const GlassBsdf<Value>& bsdf, const auto& scattering) {
  return facet_polarisation(boundary_of(bsdf.eta), kUp, scattering);
}

struct GlassMaterial {
  static constexpr bool kIsAppearance = false;
  template <typename Value, std::size_t N>
  using Bsdfs = BsdfList<GlassBsdf<Value>>;
  Colour colour;
  float ior = 1;  // inside over outside
};

inline GlassMaterial make_material(const scene::Glass& m, const SceneColours& colours) {
  return {make_colour(colours, m.colour), static_cast<float>(m.ior)};
}

inline float lobe_alpha(const GlassMaterial&) { return 0; }

template <typename Context>
void make_bsdf(typename Context::Bsdf& out, const GlassMaterial& material, const Context& at) {
  out = GlassBsdf<typename Context::Value>{at.reflectance(material.colour),
                                           at.is_outside ? material.ior : 1 / material.ior};
}

}  // namespace orbs::tracer

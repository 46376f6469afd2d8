#pragma once

#include "tracer/bsdf/bsdf_sample.h"
#include "tracer/bsdf/polarisation.h"
#include "tracer/colour/scene_colours.h"

#include <array>
#include <optional>

namespace orbs::tracer {

/// ORB.S eq. 3, a perfect mirror. The delta function cancels the cosine of the rendering equation.
template <typename Value>
struct MirrorBsdf {
  static constexpr bool kIsDelta = true;
  static constexpr bool kDepolarises = false;
  static constexpr Event kEvent = Event::Specular;
  Value reflectance{};
};

template <typename Value>
BsdfValue<Value> evaluate(const MirrorBsdf<Value>&, Vec3f, Vec3f) {
  return {};
}

template <typename Value>
std::optional<BsdfSample<Value>> sample(const MirrorBsdf<Value>& bsdf,
                                        Vec3f wo,
                                        const std::array<float, 4>&) {
  return BsdfSample<Value>{.wi = {-wo.x, -wo.y, wo.z}, .weight = bsdf.reflectance};
}

/// ORB.S's perfect mirror has no index of refraction; it reverses the field as a perfect conductor does.
template <typename Value>
std::optional<Polarisation> polarisation_by(const MirrorBsdf<Value>&, const auto& scattering) {
  constexpr snippets::AlignedMueller<float> kPerfectConductor{1, 0, -1, 0};
  const Vec3f x = scattering.frame.to_world(across_incidence(scattering.wo, kUp));
  Polarisation out{{}, x, x};
  for (std::size_t i = 0; i < 4; ++i) set_shape(out.element, i, kPerfectConductor);
  return out;
}

struct MirrorMaterial {
  static constexpr bool kIsAppearance = false;
  template <typename Value, std::size_t N>
  using Bsdfs = BsdfList<MirrorBsdf<Value>>;
  Colour reflectance;
};

inline MirrorMaterial make_material(const scene::Mirror& m, const SceneColours& colours) {
  return {make_colour(colours, m.reflectance, m.spectrum)};
}

inline float lobe_alpha(const MirrorMaterial&) { return 0; }

template <typename Context>
void make_bsdf(typename Context::Bsdf& out, const MirrorMaterial& material, const Context& at) {
  out = MirrorBsdf<typename Context::Value>{at.reflectance(material.reflectance)};
}

}  // namespace orbs::tracer

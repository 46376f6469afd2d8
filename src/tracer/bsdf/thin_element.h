#pragma once

#include "snippets/fresnel_mueller.h"
#include "tracer/bsdf/broadcast.h"
#include "tracer/bsdf/bsdf_sample.h"
#include "tracer/bsdf/polarisation.h"
#include "tracer/colour/scene_colours.h"

#include <array>
#include <numbers>
#include <optional>

/// Thin optical elements: ideal polarisers and retarders, which light crosses undeviated.
namespace orbs::tracer {

/// Unpolarised light is scaled by `element.mean`.
template <typename Value, std::size_t N>
struct ThinElementBsdf {
  static constexpr bool kIsDelta = true;
  static constexpr bool kDepolarises = false;
  static constexpr Event kEvent = Event::Specular;
  snippets::AlignedMueller<float> element;
  Vec3f axis;  // world direction of the x axis of the element, not yet projected into its plane
};

template <typename Value, std::size_t N>
BsdfValue<Value> evaluate(const ThinElementBsdf<Value, N>&, Vec3f, Vec3f) {
  return {};
}

template <typename Value, std::size_t N>
std::optional<BsdfSample<Value>> sample(const ThinElementBsdf<Value, N>& bsdf,
                                        Vec3f wo,
                                        const std::array<float, 4>&) {
  std::array<float, N> mean{};
  mean.fill(bsdf.element.mean);
  BsdfSample<Value> out{.wi = -wo, .weight = broadcast<Value>(mean)};
  out.is_transmitted = true;
  return out;
}

template <typename Value, std::size_t N>
std::optional<Polarisation> polarisation_by(const ThinElementBsdf<Value, N>& bsdf, const auto& scattering) {
  Polarisation out;
  for (std::size_t i = 0; i < N; ++i) set_shape(out.element, i, bsdf.element);
  const Vec3f within = bsdf.axis - scattering.frame.z * dot(scattering.frame.z, bsdf.axis);
  out.x_leaving = normalised(within - scattering.to_viewer * dot(scattering.to_viewer, within));
  out.x_arriving = out.x_leaving;  // light is not deviated
  return out;
}

struct ThinElementMaterial {
  static constexpr bool kIsAppearance = true;
  template <typename Value, std::size_t N>
  using Bsdfs = BsdfList<ThinElementBsdf<Value, N>>;
  snippets::AlignedMueller<float> element;
  Vec3f axis;  // unit, in the world
};

inline ThinElementMaterial make_material(const scene::Polariser& m, const SceneColours&) {
  return {snippets::polariser_along_x<float>(), cast<float>(normalised(m.axis))};
}

inline ThinElementMaterial make_material(const scene::Retarder& m, const SceneColours&) {
  constexpr double kRadians = std::numbers::pi / 180;
  return {snippets::retarder_fast_along_x(static_cast<float>(m.retardance_deg * kRadians)),
          cast<float>(normalised(m.axis))};
}

inline float lobe_alpha(const ThinElementMaterial&) { return 0; }

template <typename Context>
void make_bsdf(typename Context::Bsdf& out, const ThinElementMaterial& material, const Context&) {
  out = ThinElementBsdf<typename Context::Value, Context::kWavelengths>{material.element, material.axis};
}

}  // namespace orbs::tracer

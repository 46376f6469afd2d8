#pragma once

#include "base/in_double.h"
#include "tracer/bsdf/bsdf_sample.h"
#include "tracer/colour/scene_colours.h"
#include "tracer/sampling/warps.h"

#include <array>
#include <cmath>
#include <optional>

namespace orbs::tracer {

/// f = reflectance (n + 2) / (2 pi) cos^n of the angle to the mirrored direction (Lafortune and Willems
/// 1994).
template <typename Value>
struct PhongBsdf {
  static constexpr bool kIsDelta = false;
  static constexpr bool kDepolarises = true;
  static constexpr Event kEvent = Event::Glossy;
  Value reflectance{};
  float exponent = 10;
};

template <typename Value>
BsdfValue<Value> evaluate(const PhongBsdf<Value>& bsdf, Vec3f wo, Vec3f wi) {
  const float cosine = dot(wi, Vec3f{-wo.x, -wo.y, wo.z});
  if (wi.z <= 0 || cosine <= 0) return {};
  const float lobe = in_double::pow(cosine, bsdf.exponent) * (0.5F * kInvPi);
  return {bsdf.reflectance * (lobe * (bsdf.exponent + 2) * wi.z), lobe * (bsdf.exponent + 1)};
}

/// Directions about the mirrored one with a density proportional to cos^n.
template <typename Value>
std::optional<BsdfSample<Value>> sample(const PhongBsdf<Value>& bsdf,
                                        Vec3f wo,
                                        const std::array<float, 4>& u) {
  // For n = 0 the share u within a cosine is 1 - cosine: u[0] = 0 is the mirrored direction for every n.
  const float cosine = in_double::pow(1 - u[0], 1 / (bsdf.exponent + 1));
  const float sine = std::sqrt(std::max(0.0F, (1 - cosine) * (1 + cosine)));
  const float azimuth = 2 * kPi * u[1];
  const auto frame = frame_around(Vec3f{-wo.x, -wo.y, wo.z});
  const Vec3f wi = frame.to_world({sine * in_double::cos(azimuth), sine * in_double::sin(azimuth), cosine});
  if (wi.z <= 0) return std::nullopt;  // the lobe reaches below the surface, where it reflects nothing
  const float lobe = in_double::pow(cosine, bsdf.exponent) * (0.5F * kInvPi);
  return BsdfSample<Value>{.wi = wi,
                           .weight = bsdf.reflectance * ((bsdf.exponent + 2) / (bsdf.exponent + 1) * wi.z),
                           .pdf = lobe * (bsdf.exponent + 1)};
}

struct PhongMaterial {
  static constexpr bool kIsAppearance = true;
  template <typename Value, std::size_t N>
  using Bsdfs = BsdfList<PhongBsdf<Value>>;
  Colour reflectance;
  float exponent = 10;
};

inline PhongMaterial make_material(const scene::Phong& m, const SceneColours& colours) {
  return {make_colour(colours, m.reflectance, m.spectrum), static_cast<float>(m.exponent)};
}

/// The alpha of Beckmann's lobe that is as wide: both fall alike for alpha^2 = 2 / n of the half vector
/// (Walter et al. 2007, section 5.1), which turns half as far as the direction, so that n is 4 times as
/// large.
inline float lobe_alpha(const PhongMaterial& material) { return std::sqrt(2 / (4 * material.exponent + 2)); }

template <typename Context>
void make_bsdf(typename Context::Bsdf& out, const PhongMaterial& material, const Context& at) {
  out = PhongBsdf<typename Context::Value>{at.reflectance(material.reflectance), material.exponent};
}

}  // namespace orbs::tracer

#pragma once

#include "tracer/bsdf/bsdf_sample.h"
#include "tracer/colour/scene_colours.h"
#include "tracer/sampling/warps.h"

#include <array>
#include <optional>

namespace orbs::tracer {

/// ORB.S eq. 2: f = reflectance / pi, on both sides of the surface.
template <typename Value>
struct LambertBsdf {
  static constexpr bool kIsDelta = false;
  static constexpr bool kDepolarises = true;
  static constexpr Event kEvent = Event::Diffuse;
  Value reflectance{};
};

template <typename Value>
BsdfValue<Value> evaluate(const LambertBsdf<Value>& bsdf, Vec3f, Vec3f wi) {
  if (wi.z <= 0) return {};
  const float pdf = wi.z * kInvPi;
  return {bsdf.reflectance * pdf, pdf};
}

template <typename Value>
std::optional<BsdfSample<Value>> sample(const LambertBsdf<Value>& bsdf,
                                        Vec3f,
                                        const std::array<float, 4>& u) {
  const Vec3f wi = sample_cosine(u[0], u[1]);
  if (wi.z <= 0) return std::nullopt;
  return BsdfSample<Value>{.wi = wi, .weight = bsdf.reflectance, .pdf = wi.z * kInvPi};
}

struct LambertMaterial {
  static constexpr bool kIsAppearance = false;
  template <typename Value, std::size_t N>
  using Bsdfs = BsdfList<LambertBsdf<Value>>;
  TexturedColour reflectance;
};

inline LambertMaterial make_material(const scene::Lambert& m, const SceneColours& colours) {
  return {make_textured_colour(colours, m.reflectance, m.spectrum, m.texture)};
}

inline float lobe_alpha(const LambertMaterial&) { return kNoLobe; }

template <typename Context>
void make_bsdf(typename Context::Bsdf& out, const LambertMaterial& material, const Context& at) {
  out = LambertBsdf<typename Context::Value>{at.reflectance(material.reflectance)};
}

}  // namespace orbs::tracer

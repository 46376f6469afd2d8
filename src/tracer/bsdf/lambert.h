#pragma once

#include "tracer/sampling/warps.h"
#include "tracer/bsdf/bsdf_sample.h"

#include <array>
#include <optional>

namespace orbs::tracer {

/// ORB.S eq. 2: f = reflectance / pi, from both sides.
template <typename Value>
struct LambertBsdf {
  static constexpr bool kIsDelta = false;
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

}  // namespace orbs::tracer

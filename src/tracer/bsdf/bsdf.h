#pragma once

#include "tracer/bsdf/ggx.h"
#include "tracer/bsdf/glass.h"
#include "tracer/bsdf/lambert.h"
#include "tracer/bsdf/mirror.h"
#include "tracer/bsdf/oren_nayar.h"
#include "tracer/bsdf/rough_glass.h"

#include <variant>

namespace orbs::tracer {

/// What a surface does at one point: the material with its texture looked up and its side decided. Each
/// alternative has
///   kIsDelta, kEvent          whether it is a delta function, and its letter in the notation of light paths
///   evaluate(bsdf, wo, wi) -> BsdfValue        f |cos wi| and pdf of wi, in the local frame with wo.z > 0
///   sample(bsdf, wo, u)    -> BsdfSample       or nothing when the chosen facet reflects into the surface
/// These are the surfaces of ORB.S; interface_bsdf.h has more.
template <typename Value>
using OrbsBsdf = std::variant<LambertBsdf<Value>,
                              OrenNayarBsdf<Value>,
                              MirrorBsdf<Value>,
                              GlassBsdf<Value>,
                              GgxBsdf<Value>,
                              RoughGlassBsdf<Value>>;

template <typename... B>
bool is_delta(const std::variant<B...>& bsdf) {
  return std::visit([](const auto& b) { return b.kIsDelta; }, bsdf);
}

template <typename... B>
Event event_of(const std::variant<B...>& bsdf) {
  return std::visit([](const auto& b) { return b.kEvent; }, bsdf);
}

template <typename... B>
auto evaluate(const std::variant<B...>& bsdf, Vec3f wo, Vec3f wi) {
  return std::visit([&](const auto& b) { return evaluate(b, wo, wi); }, bsdf);
}

template <typename... B>
auto sample(const std::variant<B...>& bsdf, Vec3f wo, const std::array<float, 4>& u) {
  return std::visit([&](const auto& b) { return sample(b, wo, u); }, bsdf);
}

}  // namespace orbs::tracer

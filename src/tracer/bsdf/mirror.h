#pragma once

#include "tracer/bsdf/bsdf_sample.h"

#include <array>
#include <optional>

namespace orbs::tracer {

/// ORB.S eq. 3: the cosine of the lighting integral is divided away.
template <typename Value>
struct MirrorBsdf {
  static constexpr bool kIsDelta = true;
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

}  // namespace orbs::tracer

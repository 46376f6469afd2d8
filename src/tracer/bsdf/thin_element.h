#pragma once

#include "snippets/fresnel_mueller.h"
#include "tracer/bsdf/bsdf_sample.h"
#include "tracer/bsdf/broadcast.h"

#include <array>
#include <optional>

namespace orbs::tracer {

/// A polariser or retarder: light goes straight on. `mean` of its element is what happens to unpolarised
/// light.
template <typename Value, std::size_t N>
struct ThinElementBsdf {
  static constexpr bool kIsDelta = true;
  static constexpr Event kEvent = Event::Specular;
  snippets::AlignedMueller<float> element;
  Vec3f axis;  // of the element, in the world; neither within the sheet nor across the light yet
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

}  // namespace orbs::tracer

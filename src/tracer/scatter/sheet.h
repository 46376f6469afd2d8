#pragma once

#include "snippets/fresnel_mueller.h"
#include "tracer/scatter/bsdf_sample.h"
#include "tracer/scatter/value_of.h"

#include <array>
#include <optional>

namespace orbs::tracer {

/// A polariser or retarder: light goes straight on. `mean` of its element is what happens to unpolarised
/// light.
template <typename Value, std::size_t N>
struct SheetBsdf {
  static constexpr bool kIsDelta = true;
  static constexpr Event kEvent = Event::Specular;
  snippets::AlignedMueller<float> element;
  Vec3f axis;  // of the element, in the world; neither within the sheet nor across the light yet
};

template <typename Value, std::size_t N>
BsdfValue<Value> evaluate(const SheetBsdf<Value, N>&, Vec3f, Vec3f) {
  return {};
}

template <typename Value, std::size_t N>
std::optional<BsdfSample<Value>> sample(const SheetBsdf<Value, N>& bsdf,
                                        Vec3f wo,
                                        const std::array<float, 4>&) {
  std::array<float, N> mean{};
  mean.fill(bsdf.element.mean);
  BsdfSample<Value> out{.wi = -wo, .weight = value_of<Value>(mean)};
  out.is_transmitted = true;
  return out;
}

}  // namespace orbs::tracer

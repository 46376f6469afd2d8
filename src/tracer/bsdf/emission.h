#pragma once

#include "tracer/bsdf/lambert.h"

namespace orbs::tracer {

/// Emits from both sides and reflects nothing; paths end there.
struct EmissionMaterial {
  static constexpr bool kIsAppearance = false;
  template <typename Value, std::size_t N>
  using Bsdfs = BsdfList<>;  // Lambert's, which is black
  TexturedColour radiance;
};

inline EmissionMaterial make_material(const scene::Emission& m, const SceneColours& colours) {
  return {make_textured_colour(colours, m.radiance, m.spectrum, m.texture)};
}

inline float lobe_alpha(const EmissionMaterial&) { return kNoLobe; }

template <typename Context>
void make_bsdf(typename Context::Bsdf& out, const EmissionMaterial&, const Context&) {
  out = LambertBsdf<typename Context::Value>{};
}

}  // namespace orbs::tracer

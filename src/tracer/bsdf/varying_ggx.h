#pragma once

#include "tracer/bsdf/anisotropic_ggx.h"
#include "tracer/bsdf/mirror.h"

#include <algorithm>

namespace orbs::tracer {

/// Ggx or, where a texture has no roughness, a mirror: it has the BSDFs of AnisotropicGgxMaterial and of
/// that.
struct VaryingGgxMaterial {
  static constexpr bool kIsAppearance = true;
  template <typename Value, std::size_t N>
  using Bsdfs = BsdfList<>;
  Colour colour;
  TexturedColour roughness;
  bool is_glossiness = false;
  bool is_correlated = true;
};

inline VaryingGgxMaterial make_material(const scene::VaryingGgx& m, const SceneColours& colours) {
  return {make_colour(colours, m.colour, m.spectrum),
          make_textured_colour(colours, {m.alpha, m.alpha, m.alpha}, {}, m.texture), m.is_glossiness,
          m.masking == scene::Masking::Correlated};
}

inline float lobe_alpha(const VaryingGgxMaterial&) { return kPartlyDelta; }

template <typename Context>
void make_bsdf(typename Context::Bsdf& out, const VaryingGgxMaterial& material, const Context& at) {
  using Value = typename Context::Value;
  const float held = at.textured(material.roughness).x;
  const float alpha = material.is_glossiness ? 1 - held : held;
  const Value colour = at.reflectance(material.colour);
  // A lobe that is narrower than float directions can resolve is the mirror, see scene::load_alpha.
  constexpr float kLeastAlpha = 1e-4F;
  if (alpha < kLeastAlpha)
    out = MirrorBsdf<Value>{colour};
  else
    out = AnisotropicGgxBsdf<Value>{colour, {alpha, alpha}, {1, 0}, material.is_correlated};
}

}  // namespace orbs::tracer

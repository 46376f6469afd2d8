#pragma once

#include "scene/materials/boundary.h"
#include "scene/materials/glass.h"
#include "scene/materials/material_type.h"
#include "scene/materials/reflectance.h"

namespace orbs::scene {

/// Rough dielectric after Walter et al. 2007 with GGX; masking is height-correlated in reflection, separable
/// in transmission.
struct RoughGlass {
  static constexpr const char* kType = "rough_glass";
  RgbColour colour;
  double ior = 1.5;
  double alpha = 0.1;
  bool operator==(const RoughGlass&) const = default;
};

inline void load(const MaterialEntry& entry, RoughGlass& loaded) {
  const RgbColour colour = entry.in.vec3_or("colour", {1, 1, 1}, {0.0, 1.0});
  const double ior = load_ior(entry.in);
  loaded = {colour, ior, load_alpha(entry.in)};
}

inline void write(json::Writer& out, const SpectrumList&, const RoughGlass& m) {
  out.member("colour", m.colour).member("ior", m.ior).member("alpha", m.alpha);
}

inline MaterialRequirement requirement(const RoughGlass&) { return {"A4", "rough glass"}; }

inline std::vector<EffectVerdict> effects(const SpectrumList&, const RoughGlass& m) {
  return {effect_of(Roughness{m.alpha})};
}

inline bool is_coloured(const SpectrumList&, const RoughGlass& m) { return !is_grey(m.colour); }

}  // namespace orbs::scene

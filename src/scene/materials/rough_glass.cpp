#include "scene/materials/rough_glass.h"

#include "scene/materials/boundary.h"
#include "scene/materials/glass.h"
#include "scene/materials/reflectance.h"

namespace orbs::scene {

void load(const MaterialEntry& entry, RoughGlass& loaded) {
  const RgbColour colour = entry.in.vec3_or("colour", {1, 1, 1}, {0.0, 1.0});
  const double ior = load_ior(entry.in);
  loaded = {colour, ior, load_alpha(entry.in)};
}

void write(json::Writer& out, const SpectrumList&, const RoughGlass& m) {
  out.member("colour", m.colour).member("ior", m.ior).member("alpha", m.alpha);
}

MaterialRequirement requirement(const RoughGlass&) { return {"A4", "rough glass"}; }

std::vector<EffectVerdict> effects(const SpectrumList&, const RoughGlass& m) {
  return {effect_of(Roughness{m.alpha})};
}

bool is_coloured(const SpectrumList&, const RoughGlass& m) { return !is_grey(m.colour); }

}  // namespace orbs::scene

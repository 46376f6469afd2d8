#include "scene/materials/ggx.h"

#include "scene/load/write_spectra.h"
#include "scene/materials/boundary.h"
#include "scene/materials/reflectance.h"

namespace orbs::scene {

void load(const MaterialEntry& entry, Ggx& loaded) {
  const auto colour = load_reflectance(entry.in, "colour", entry.spectra);
  loaded = {colour.rgb, load_alpha(entry.in), colour.spectrum};
}

void write(json::Writer& out, const SpectrumList& spectra, const Ggx& m) {
  write_colour(out, spectra, "colour", m.colour, m.spectrum);
  out.member("alpha", m.alpha);
}

// No M level of ORB.S defines glossy reflection: it brings that with the paths of A2, as rough glass with A4.
MaterialRequirement requirement(const Ggx&) { return {"A2", "a glossy reflector (GGX)"}; }

std::vector<EffectVerdict> effects(const SpectrumList& spectra, const Ggx& m) {
  auto found = effects_of_reflectance(spectra, m.spectrum);
  found.push_back(effect_of(Roughness{m.alpha}));
  return found;
}

bool is_coloured(const SpectrumList& spectra, const Ggx& m) {
  return is_coloured(spectra, m.colour, m.spectrum);
}

}  // namespace orbs::scene

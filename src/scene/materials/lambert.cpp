#include "scene/materials/lambert.h"

#include "json/writer.h"
#include "scene/load/write_spectra.h"
#include "scene/materials/reflectance.h"

namespace orbs::scene {

void load(const MaterialEntry& entry, Lambert& loaded) {
  const auto colour = load_reflectance(entry.in, "reflectance", entry.spectra);
  loaded = {colour.rgb, load_tinted_texture(entry, colour), colour.spectrum};
}

void write(json::Writer& out, const SpectrumList& spectra, const Lambert& m) {
  write_colour(out, spectra, "reflectance", m.reflectance, m.spectrum);
}

MaterialRequirement requirement(const Lambert&) { return {"M1", "Lambertian"}; }

std::vector<EffectVerdict> effects(const SpectrumList& spectra, const Lambert& m) {
  return effects_of_reflectance(spectra, m.spectrum);
}

bool is_coloured(const SpectrumList& spectra, const Lambert& m) {
  return m.texture || is_coloured(spectra, m.reflectance, m.spectrum);
}

}  // namespace orbs::scene

#include "scene/materials/mirror.h"

#include "json/writer.h"
#include "scene/load/write_spectra.h"
#include "scene/materials/reflectance.h"

namespace orbs::scene {

void load(const MaterialEntry& entry, Mirror& loaded) {
  const auto colour = load_reflectance(entry.in, "reflectance", entry.spectra);
  loaded = {colour.rgb, colour.spectrum};
}

void write(json::Writer& out, const SpectrumList& spectra, const Mirror& m) {
  write_colour(out, spectra, "reflectance", m.reflectance, m.spectrum);
}

MaterialRequirement requirement(const Mirror&) { return {"M3", "a mirror"}; }

std::vector<EffectVerdict> effects(const SpectrumList& spectra, const Mirror& m) {
  return effects_of_reflectance(spectra, m.spectrum);
}

bool is_coloured(const SpectrumList& spectra, const Mirror& m) {
  return is_coloured(spectra, m.reflectance, m.spectrum);
}

}  // namespace orbs::scene

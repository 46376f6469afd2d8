#include "scene/materials/oren_nayar.h"

#include "json/writer.h"
#include "scene/load/write_spectra.h"
#include "scene/materials/reflectance.h"

namespace orbs::scene {

void load(const MaterialEntry& entry, OrenNayar& loaded) {
  const auto colour = load_reflectance(entry.in, "reflectance", entry.spectra);
  const double roughness = entry.in.number("roughness", {0.0, 1.0});
  loaded = {colour.rgb, roughness, load_tinted_texture(entry, colour), colour.spectrum};
}

void write(json::Writer& out, const SpectrumList& spectra, const OrenNayar& m) {
  write_colour(out, spectra, "reflectance", m.reflectance, m.spectrum);
  out.member("roughness", m.roughness);
}

MaterialRequirement requirement(const OrenNayar&) { return {"M7", "Oren-Nayar"}; }

std::vector<EffectVerdict> effects(const SpectrumList& spectra, const OrenNayar& m) {
  return effects_of_reflectance(spectra, m.spectrum);
}

bool is_coloured(const SpectrumList& spectra, const OrenNayar& m) {
  return m.texture || is_coloured(spectra, m.reflectance, m.spectrum);
}

}  // namespace orbs::scene

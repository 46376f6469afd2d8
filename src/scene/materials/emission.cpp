#include "scene/materials/emission.h"

#include "scene/load/write_spectra.h"
#include "scene/materials/reflectance.h"

namespace orbs::scene {

void load(const MaterialEntry& entry, Emission& loaded) {
  const auto radiance = load_radiance(entry.in, "radiance", entry.spectra);
  loaded = {radiance.rgb, load_tinted_texture(entry, radiance), radiance.spectrum};
}

void write(json::Writer& out, const SpectrumList& spectra, const Emission& m) {
  write_colour(out, spectra, "radiance", m.radiance, m.spectrum);
}

MaterialRequirement requirement(const Emission&) { return {"M2", "emissive"}; }

// Whether its spectrum counts depends on the surfaces that it lights: scene::effects judges it as a light.
std::vector<EffectVerdict> effects(const SpectrumList&, const Emission&) { return {}; }

bool is_coloured(const SpectrumList&, const Emission&) { return false; }

}  // namespace orbs::scene

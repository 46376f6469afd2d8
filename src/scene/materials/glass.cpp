#include "scene/materials/glass.h"

#include "json/object_reader.h"
#include "json/writer.h"
#include "scene/materials/reflectance.h"

namespace orbs::scene {

double load_ior(json::ObjectReader& in) { return in.number("ior", {0.1, 10.0}); }

void load(const MaterialEntry& entry, Glass& loaded) {
  const RgbColour colour = entry.in.vec3_or("colour", {1, 1, 1}, {0.0, 1.0});
  loaded = {colour, load_ior(entry.in)};
}

void write(json::Writer& out, const SpectrumList&, const Glass& m) {
  out.member("colour", m.colour).member("ior", m.ior);
}

MaterialRequirement requirement(const Glass&) { return {"M8", "smooth glass"}; }

std::vector<EffectVerdict> effects(const SpectrumList&, const Glass&) { return {}; }

bool is_coloured(const SpectrumList&, const Glass& m) { return !is_grey(m.colour); }

}  // namespace orbs::scene

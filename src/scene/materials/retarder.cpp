#include "scene/materials/retarder.h"

#include "json/object_reader.h"
#include "json/writer.h"
#include "scene/materials/polariser.h"

#include <cmath>

#include <fmt/format.h>

namespace orbs::scene {

void load(const MaterialEntry& entry, Retarder& loaded) {
  loaded.axis = load_axis(entry.in);
  loaded.retardance_deg = entry.in.number("retardance_deg", {-3600.0, 3600.0});
}

void write(json::Writer& out, const SpectrumList&, const Retarder& m) {
  out.member("axis", m.axis).member("retardance_deg", m.retardance_deg);
}

MaterialRequirement requirement(const Retarder&) { return {"E3", "a retarder"}; }

std::vector<EffectVerdict> effects(const SpectrumList&, const Retarder& m) {
  if (std::fmod(m.retardance_deg, 360) == 0)
    return {
        {Effect::Polarisation, false, fmt::format("retards by {} degrees, whole waves", m.retardance_deg)}};
  return {{Effect::Polarisation, true, fmt::format("retards by {} degrees", m.retardance_deg)}};
}

bool is_coloured(const SpectrumList&, const Retarder&) { return false; }

}  // namespace orbs::scene

#include "scene/materials/polariser.h"

#include "json/object_reader.h"
#include "json/writer.h"

namespace orbs::scene {

Vec3d load_axis(json::ObjectReader& in) {
  const Vec3d axis = in.vec3("axis");
  if (length(axis) == 0) in.fail("axis", "must have a length: it is a direction in the world");
  return axis;
}

void load(const MaterialEntry& entry, Polariser& loaded) { loaded.axis = load_axis(entry.in); }

void write(json::Writer& out, const SpectrumList&, const Polariser& m) { out.member("axis", m.axis); }

MaterialRequirement requirement(const Polariser&) { return {"E3", "a polariser"}; }

std::vector<EffectVerdict> effects(const SpectrumList&, const Polariser&) {
  return {{Effect::Polarisation, true, "is a polariser"}};
}

bool is_coloured(const SpectrumList&, const Polariser&) { return false; }

}  // namespace orbs::scene

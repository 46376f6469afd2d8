#pragma once

#include "json/object_reader.h"
#include "json/writer.h"
#include "scene/materials/material_type.h"

namespace orbs::scene {

/// Ideal thin element that light crosses straight on. The axis, a world direction, is projected into the
/// surface: along it a polariser transmits everything, across it nothing.
struct Polariser {
  static constexpr const char* kType = "polariser";
  Vec3d axis;
  bool operator==(const Polariser&) const = default;
};

/// "axis", a direction of any length but zero, as polarisers and retarders have it.
inline Vec3d load_axis(json::ObjectReader& in) {
  const Vec3d axis = in.vec3("axis");
  if (length(axis) == 0) in.fail("axis", "must have a length: it is a direction in the world");
  return axis;
}

inline void load(const MaterialEntry& entry, Polariser& loaded) { loaded.axis = load_axis(entry.in); }

inline void write(json::Writer& out, const SpectrumList&, const Polariser& m) { out.member("axis", m.axis); }

inline MaterialRequirement requirement(const Polariser&) { return {"E3", "a polariser"}; }

inline std::vector<EffectVerdict> effects(const SpectrumList&, const Polariser&) {
  return {{Effect::Polarisation, true, "is a polariser"}};
}

inline bool is_coloured(const SpectrumList&, const Polariser&) { return false; }

}  // namespace orbs::scene

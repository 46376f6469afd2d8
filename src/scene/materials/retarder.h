#pragma once

#include "json/object_reader.h"
#include "json/writer.h"
#include "scene/materials/material_type.h"
#include "scene/materials/polariser.h"

#include <cmath>

#include <fmt/format.h>

namespace orbs::scene {

/// Ideal thin element as Polariser. The axis is its fast axis: light polarised across it comes
/// `retardance_deg` late, at all wavelengths.
struct Retarder {
  static constexpr const char* kType = "retarder";
  Vec3d axis;
  double retardance_deg = 90;
  bool operator==(const Retarder&) const = default;
};

inline void load(const MaterialEntry& entry, Retarder& loaded) {
  loaded.axis = load_axis(entry.in);
  loaded.retardance_deg = entry.in.number("retardance_deg", {-3600.0, 3600.0});
}

inline void write(json::Writer& out, const SpectrumList&, const Retarder& m) {
  out.member("axis", m.axis).member("retardance_deg", m.retardance_deg);
}

inline MaterialRequirement requirement(const Retarder&) { return {"E3", "a retarder"}; }

inline std::vector<EffectVerdict> effects(const SpectrumList&, const Retarder& m) {
  if (std::fmod(m.retardance_deg, 360) == 0)
    return {
        {Effect::Polarisation, false, fmt::format("retards by {} degrees, whole waves", m.retardance_deg)}};
  return {{Effect::Polarisation, true, fmt::format("retards by {} degrees", m.retardance_deg)}};
}

inline bool is_coloured(const SpectrumList&, const Retarder&) { return false; }

}  // namespace orbs::scene

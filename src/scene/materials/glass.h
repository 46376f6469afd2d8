#pragma once

#include "json/object_reader.h"
#include "json/writer.h"
#include "scene/materials/material_type.h"
#include "scene/materials/reflectance.h"

namespace orbs::scene {

/// Smooth dielectric of ORB.S REQ_M8; `ior` is inside over outside, and the vertex normals point outside.
struct Glass {
  static constexpr const char* kType = "glass";
  RgbColour colour;
  double ior = 1.5;
  bool operator==(const Glass&) const = default;
};

/// "ior" in [0.1, 10].
inline double load_ior(json::ObjectReader& in) { return in.number("ior", {0.1, 10.0}); }

inline void load(const MaterialEntry& entry, Glass& loaded) {
  const RgbColour colour = entry.in.vec3_or("colour", {1, 1, 1}, {0.0, 1.0});
  loaded = {colour, load_ior(entry.in)};
}

inline void write(json::Writer& out, const SpectrumList&, const Glass& m) {
  out.member("colour", m.colour).member("ior", m.ior);
}

inline MaterialRequirement requirement(const Glass&) { return {"M8", "smooth glass"}; }

inline std::vector<EffectVerdict> effects(const SpectrumList&, const Glass&) { return {}; }

inline bool is_coloured(const SpectrumList&, const Glass& m) { return !is_grey(m.colour); }

}  // namespace orbs::scene

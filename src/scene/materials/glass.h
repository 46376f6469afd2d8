#pragma once

#include "scene/materials/material_type.h"

namespace orbs::scene {

/// Smooth dielectric of ORB.S REQ_M8; `ior` is inside over outside, and the vertex normals point outside.
struct Glass {
  static constexpr const char* kType = "glass";
  RgbColour colour;
  double ior = 1.5;
  bool operator==(const Glass&) const = default;
};

void load(const MaterialEntry& entry, Glass& loaded);
void write(json::Writer& out, const SpectrumList& spectra, const Glass& m);
MaterialRequirement requirement(const Glass& m);
std::vector<EffectVerdict> effects(const SpectrumList& spectra, const Glass& m);
bool is_coloured(const SpectrumList& spectra, const Glass& m);

/// "ior" in [0.1, 10].
double load_ior(json::ObjectReader& in);

}  // namespace orbs::scene

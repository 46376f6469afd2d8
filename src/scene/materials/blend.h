#pragma once

#include "scene/materials/material_type.h"
#include "scene/texture.h"

#include <array>
#include <optional>
#include <string>

namespace orbs::scene {

/// Of all light the part w by the second material and the rest by the first: w is `weight` times the red
/// channel of the texture.
struct Blend {
  static constexpr const char* kType = "blend";
  struct Part {
    std::string name;
    int material = 0;  // index into Scene::materials, below that of the blend
    bool operator==(const Part&) const = default;
  };
  std::array<Part, 2> parts;
  double weight = 0.5;
  std::optional<TextureUse> texture;
  bool operator==(const Blend&) const = default;
};

void load(const MaterialEntry& entry, Blend& loaded);
void write(json::Writer& out, const SpectrumList& spectra, const Blend& m);
inline MaterialRequirement requirement(const Blend&) { return {"B6", "a blend of two materials"}; }
/// What the parts call for is found at them.
inline std::vector<EffectVerdict> effects(const SpectrumList&, const Blend&) { return {}; }
inline bool is_coloured(const SpectrumList&, const Blend&) { return false; }

}  // namespace orbs::scene

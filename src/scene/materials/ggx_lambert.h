#pragma once

#include "json/object_reader.h"
#include "json/writer.h"
#include "scene/colour.h"
#include "scene/materials/boundary.h"
#include "scene/materials/material_type.h"

#include <algorithm>
#include <string>

namespace orbs::scene {

/// Who gives way where a glossy and a diffuse reflectance exceed 1 together.
enum class Mix {
  Maximum,       // the diffuse part, to 1 less the largest component of the glossy colour
  Average,       // the diffuse part, to 1 less the mean of the glossy colour
  PerComponent,  // each component of the diffuse part, to 1 less that of the glossy colour
  Sum            // both, each component by the sum of the two
};

/// The sum of Ggx and Lambert as the draft of ORB.S has it.
struct GgxLambert {
  static constexpr const char* kType = "ggx_lambert";
  RgbColour colour;  // of the glossy part
  double alpha = 0.1;
  RgbColour diffuse;  // reflectance of the diffuse part, before it gives way
  Mix mix = Mix::Maximum;
  bool operator==(const GgxLambert&) const = default;
};

/// What is left of both after one gave way.
struct MixedColours {
  RgbColour glossy;
  RgbColour diffuse;
};
inline MixedColours mixed_colours(const GgxLambert& m) {
  const RgbColour r = m.colour;
  const RgbColour d = m.diffuse;
  if (m.mix == Mix::PerComponent)
    return {r, {std::min(d.x, 1 - r.x), std::min(d.y, 1 - r.y), std::min(d.z, 1 - r.z)}};
  if (m.mix == Mix::Sum) {
    const RgbColour share{1 / std::max(1.0, r.x + d.x), 1 / std::max(1.0, r.y + d.y),
                          1 / std::max(1.0, r.z + d.z)};
    return {r * share, d * share};
  }
  const double taken = m.mix == Mix::Maximum ? std::max({r.x, r.y, r.z}) : (r.x + r.y + r.z) / 3;
  const double largest = std::max({d.x, d.y, d.z});
  return {r, d * (largest > 1 - taken ? (1 - taken) / largest : 1)};
}

/// The same as a weighted mean of the two, for programs that have no sum: of all hits the part `weight` shows
/// Lambert's law. The colours may exceed 1, which they do only where those of both exceed 1 together.
struct MixAsMean {
  double weight = 0;
  RgbColour glossy;
  RgbColour diffuse;
};
inline MixAsMean mix_as_mean(const GgxLambert& m) {
  const auto [glossy, diffuse] = mixed_colours(m);
  const double g = std::max({glossy.x, glossy.y, glossy.z});
  const double d = std::max({diffuse.x, diffuse.y, diffuse.z});
  if (!(d > 0)) return {0, glossy, diffuse};
  const double weight = d / (g + d);
  return {weight, weight < 1 ? glossy / (1 - weight) : glossy, diffuse / weight};
}

inline void load(const MaterialEntry& entry, GgxLambert& loaded) {
  auto& in = entry.in;
  loaded = {in.vec3("colour", {0.0, 1.0}), load_alpha(in), in.vec3("diffuse", {0.0, 1.0})};
  const auto word = in.one_of("mix", {"maximum", "average", "per_component", "sum"});
  loaded.mix = word == "average"         ? Mix::Average
               : word == "per_component" ? Mix::PerComponent
               : word == "sum"           ? Mix::Sum
                                         : Mix::Maximum;
}

inline const char* word_of(Mix mix) {
  switch (mix) {
    case Mix::Maximum:
      return "maximum";
    case Mix::Average:
      return "average";
    case Mix::PerComponent:
      return "per_component";
    case Mix::Sum:
      return "sum";
  }
  return "";
}

inline void write(json::Writer& out, const SpectrumList&, const GgxLambert& m) {
  out.member("colour", m.colour).member("alpha", m.alpha).member("diffuse", m.diffuse);
  out.member("mix", word_of(m.mix));
}

inline MaterialRequirement requirement(const GgxLambert&) { return {"B9", "a mix of ggx and lambert"}; }

inline std::vector<EffectVerdict> effects(const SpectrumList&, const GgxLambert& m) {
  return {effect_of(Roughness{m.alpha})};
}

inline bool is_coloured(const SpectrumList&, const GgxLambert& m) {
  return !is_grey(m.colour) || !is_grey(m.diffuse);
}

}  // namespace orbs::scene

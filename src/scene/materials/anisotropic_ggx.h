#pragma once

#include "json/object_reader.h"
#include "json/writer.h"
#include "scene/load/spectra.h"
#include "scene/materials/boundary.h"
#include "scene/materials/material_type.h"
#include "scene/materials/reflectance.h"

#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

namespace orbs::scene {

/// colour * D G / (4 cos cos) as Ggx, without a Fresnel factor, of microfacets whose slopes differ along and
/// across the surface's direction of increasing u, turned by `rotation_deg` counter-clockwise seen from
/// outside.
struct AnisotropicGgx {
  static constexpr const char* kType = "anisotropic_ggx";
  RgbColour colour;
  double alpha_x = 0.1;
  double alpha_y = 0.1;
  double rotation_deg = 0;
  Masking masking = Masking::Correlated;
  std::optional<SpectrumUse> spectrum = {};
  bool operator==(const AnisotropicGgx&) const = default;
};

/// The two alphas along and across the direction of increasing u where the rotation turns by quarters;
/// nothing where programs without a rotation cannot show it.
inline std::optional<std::array<double, 2>> alphas_unturned(const AnisotropicGgx& m) {
  const double quarters = m.rotation_deg / 90;
  if (quarters != std::floor(quarters)) return std::nullopt;
  const bool is_odd = static_cast<int>(quarters) % 2 != 0;
  return is_odd ? std::array{m.alpha_y, m.alpha_x} : std::array{m.alpha_x, m.alpha_y};
}

inline void load(const MaterialEntry& entry, AnisotropicGgx& loaded) {
  auto& in = entry.in;
  const auto colour = load_reflectance(in, "colour", entry.spectra);
  loaded = {colour.rgb, load_alpha(in, "alpha_x"), load_alpha(in, "alpha_y"),
            in.number_or("rotation", 0, {-360, 360})};
  loaded.masking = load_masking(in);
  loaded.spectrum = colour.spectrum;
}

inline void write(json::Writer& out, const SpectrumList& spectra, const AnisotropicGgx& m) {
  write_colour(out, spectra, "colour", m.colour, m.spectrum);
  out.member("alpha_x", m.alpha_x).member("alpha_y", m.alpha_y).member("rotation", m.rotation_deg);
  out.member("masking", word_of(m.masking));
}

inline MaterialRequirement requirement(const AnisotropicGgx&) {
  return {"B2", "an anisotropic glossy reflector"};
}

inline std::vector<EffectVerdict> effects(const SpectrumList& spectra, const AnisotropicGgx& m) {
  auto found = effects_of_reflectance(spectra, m.spectrum);
  found.push_back({Effect::RoughBoundary, true,
                   fmt::format("is rough (GGX, alpha {} along and {} across)", m.alpha_x, m.alpha_y)});
  return found;
}

inline bool is_coloured(const SpectrumList& spectra, const AnisotropicGgx& m) {
  return is_coloured(spectra, m.colour, m.spectrum);
}

}  // namespace orbs::scene

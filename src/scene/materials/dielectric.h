#pragma once

#include "scene/materials/material_type.h"
#include "scene/spectral.h"

#include <optional>

namespace orbs::scene {

/// A dielectric by its indices, else as Conductor. The vertex normals point outside; an open sheet is one
/// boundary. Radiance is scaled by the squared ratio of the indices on refraction.
struct Dielectric {
  static constexpr const char* kType = "dielectric";
  spectra::RefractiveIndex index;
  spectra::RefractiveIndex outside = spectra::constant(1);
  std::optional<Roughness> roughness;
  std::optional<Film> film;
  bool operator==(const Dielectric&) const = default;
};

void load(const MaterialEntry& entry, Dielectric& loaded);
void write(json::Writer& out, const SpectrumList& spectra, const Dielectric& m);
MaterialRequirement requirement(const Dielectric& m);
std::vector<EffectVerdict> effects(const SpectrumList& spectra, const Dielectric& m);
bool is_coloured(const SpectrumList& spectra, const Dielectric& m);

/// An index that varies by less refracts 1e-6 radians differently, a thousandth of a pixel of an image of
/// 1000 pixels.
constexpr double kLeastDispersion = 1e-6;

/// Whether the boundary refracts light of different wavelengths differently by more than that.
bool is_dispersive(const Dielectric& m);

/// Without roughness and film it is the smooth glass of ORB.S REQ_M8.
bool is_smooth_glass(const Dielectric& m);

/// Makes the dielectric as it would be without the effect: Dispersion and ThinFilm; others change nothing.
void leave_out(Effect effect, Dielectric& m);

}  // namespace orbs::scene

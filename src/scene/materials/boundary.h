#pragma once

#include "json/writer.h"
#include "scene/materials/material_type.h"
#include "scene/spectral.h"

#include <optional>

/// What materials by their indices share: a boundary between the index of the material and that outside,
/// smooth or rough, with or without a film.
namespace orbs::scene {

/// "outside", a vacuum when absent.
spectra::RefractiveIndex load_outside(const MaterialEntry& entry);
/// "alpha", "distribution" and "masking"; nothing without "alpha": the boundary is smooth.
std::optional<Roughness> load_roughness(const MaterialEntry& entry);
/// "film", when there is one.
std::optional<Film> load_film(const MaterialEntry& entry);
/// "alpha" in [1e-4, 1]: below, a lobe is narrower than float directions can resolve, and the surface is a
/// mirror.
double load_alpha(json::ObjectReader& in, const char* key = "alpha");

/// "masking", height-correlated when absent as that of Ggx.
Masking load_masking(json::ObjectReader& in);
inline const char* word_of(Masking masking) {
  return masking == Masking::Separable ? "separable" : "correlated";
}

/// The members that the functions above read.
void write_boundary(json::Writer& out,
                    const spectra::RefractiveIndex& outside,
                    const std::optional<Roughness>& roughness,
                    const std::optional<Film>& film);

/// Range of a / b over all light: refraction depends on nothing else.
struct IndexRatio {
  double smallest = 0;
  double largest = 0;
  double span() const { return largest - smallest; }
};
IndexRatio index_ratio(const spectra::RefractiveIndex& a, const spectra::RefractiveIndex& b);
bool is_everywhere_equal(const spectra::RefractiveIndex& a, const spectra::RefractiveIndex& b);

EffectVerdict effect_of(const Roughness& roughness);
/// `is_base_same`: the film has the index of the material below it.
EffectVerdict effect_of(const Film& film, const spectra::RefractiveIndex& outside, bool is_base_same);

/// The wavelength at which indices are usually quoted: helium's d line.
constexpr double kUsualIndex_nm = 587.56;
/// The index of kUsualIndex_nm at all wavelengths.
spectra::RefractiveIndex frozen(const spectra::RefractiveIndex& index);

}  // namespace orbs::scene

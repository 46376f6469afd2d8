#pragma once

#include "scene/scene.h"

#include <vector>

/// Spectra as lists of numbers, for renderers that read them in this form.
namespace orbs::adapters {

/// The whole nanometres that are seen, 360 to 830: evenly spaced, ends included, since Mitsuba and pbrt take
/// a spectrum for zero beyond its list, and some versions of Mitsuba take any list for an evenly spaced one.
const std::vector<double>& sampled_wavelengths_nm();

/// Values at sampled_wavelengths_nm(), as floats, which is what both renderers compute with; one value where
/// all are the same.
using Samples = std::vector<float>;

Samples samples_of(const spectra::Spectrum& spectrum);
/// The ratio index / outside: boundaries depend on nothing else.
Samples samples_of_ratio(const spectra::RefractiveIndex& index, const spectra::RefractiveIndex& outside);
/// Samples of n and k of a metal, each over the index outside.
Samples samples_of_n(const scene::Conductor& metal);
Samples samples_of_k(const scene::Conductor& metal);

/// The reflectance of a surface of this colour, or the spectrum in its place.
spectra::Spectrum reflected(const scene::Scene& scene,
                            scene::RgbColour colour,
                            const std::optional<scene::SpectrumUse>& use);

/// A light's values at sampled_wavelengths_nm(), scaled so that those of luminance 1 have Y = 1.
Samples light_samples(const scene::Scene& scene,
                      scene::RgbColour colour,
                      const std::optional<scene::SpectrumUse>& use);

/// Y of such samples, by the CIE's 2 degree observer.
double luminance_of(const Samples& light);

}  // namespace orbs::adapters

#pragma once

#include "snippets/fluorescence.h"
#include "spectra/refractive_index.h"
#include "spectra/spectrum.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

/// What a scene says wavelength by wavelength. Where it gives a colour instead, linear Rec.709 means
/// spectra::reflectance_of_rgb for surfaces, and that times D65 for lights.
namespace orbs::scene {

struct NamedSpectrum {
  std::string name;
  spectra::Spectrum spectrum;
  bool operator==(const NamedSpectrum&) const = default;
};

/// A spectrum of the scene in the place of a colour: its values times `scale`. The colour beside it is then
/// what the eye makes of it: a surface under D65, a light by itself. It may lie outside of Rec.709, hence be
/// negative.
struct SpectrumUse {
  int spectrum = 0;
  double scale = 1;
  bool operator==(const SpectrumUse&) const = default;
};

/// A layer of even thickness on the surface; all reflections within it interfere.
struct Film {
  spectra::RefractiveIndex index;
  double height_nm = 0;
  bool operator==(const Film&) const = default;
};

enum class Distribution { Ggx, Beckmann };
enum class Masking { Separable, Correlated };

/// Isotropic microfacets that scatter once (Walter et al. 2007); `masking` holds for reflection and
/// transmission alike.
struct Roughness {
  double alpha = 0.1;
  Distribution distribution = Distribution::Ggx;
  Masking masking = Masking::Separable;
  bool operator==(const Roughness&) const = default;
};

/// Share of the energy at one wavelength that leaves at a longer one; data/snippets/fluorescence.h defines
/// both forms. The diagonal of a matrix is zero here: what keeps its wavelength is the material's
/// reflectance.
using Reradiation = std::variant<snippets::TentKernel<double>, snippets::ReradiationMatrix<double>>;

struct WavelengthRange {
  double first_nm = 0;
  double last_nm = 0;
};

/// Where a kernel may differ from zero, by incoming and by outgoing wavelength.
struct KernelSupport {
  WavelengthRange in;
  WavelengthRange out;
};
/// Nothing when the kernel is zero for all light from kShortestLight_nm to kLongestSeen_nm.
std::optional<KernelSupport> support_of(const Reradiation& kernel);

}  // namespace orbs::scene

#pragma once

#include "scene/colour.h"
#include "snippets/fluorescence.h"
#include "spectra/refractive_index.h"
#include "spectra/spectrum.h"

#include <optional>
#include <variant>
#include <vector>

/// Properties of materials that depend on the wavelength.
namespace orbs::scene {

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
/// both forms. The diagonal of a matrix is zero here: light that keeps its wavelength is the material's
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

/// kShortestLight_nm to kLongestSeen_nm in steps of a nanometre: where spectra are compared.
std::vector<double> whole_nanometres();

}  // namespace orbs::scene

#pragma once

#include "spectra/spectrum.h"

#include <array>
#include <complex>
#include <variant>

/// Indices of refraction. Complex ones are n + i k with k > 0 where the material absorbs (fields vary as
/// exp(-i w t)).
namespace orbs::spectra {

/// n^2 = 1 + sum of b L^2 / (L^2 - c) with L the wavelength in micrometres (W. Sellmeier 1871).
struct Sellmeier {
  std::array<double, 4> b{};
  std::array<double, 4> c_um2{};
  bool operator==(const Sellmeier&) const = default;
};

/// n = a + b / L^2 + c / L^4 + d / L^6 with L the wavelength in micrometres (A. L. Cauchy 1836).
struct Cauchy {
  double a = 1;
  double b = 0;
  double c = 0;
  double d = 0;
  bool operator==(const Cauchy&) const = default;
};

/// A spectrum may be a constant. The formulas are used as they stand outside of the range that they were
/// fitted in.
using RefractiveIndex = std::variant<Spectrum, Sellmeier, Cauchy>;

double index_at(const RefractiveIndex& index, double wavelength_nm);

/// Whether light of different wavelengths is refracted differently, anywhere from kShortestLight_nm to
/// kLongestSeen_nm.
bool is_dispersive(const RefractiveIndex& index);

/// Smallest index at the whole nanometres from kShortestLight_nm to kLongestSeen_nm: what must be above 0 for
/// a glass to be one. NaN where a formula has no real value (between its resonances).
double smallest_index(const RefractiveIndex& index);

struct MetalIndex {
  Spectrum n;
  Spectrum k;
  bool operator==(const MetalIndex&) const = default;
};

std::complex<double> index_at(const MetalIndex& metal, double wavelength_nm);

}  // namespace orbs::spectra

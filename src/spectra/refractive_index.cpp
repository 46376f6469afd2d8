#include "spectra/refractive_index.h"

#include <algorithm>
#include <cmath>

namespace orbs::spectra {

namespace {

double square_of_micrometres(double wavelength_nm) { return wavelength_nm * wavelength_nm * 1e-6; }

double index_at(const Sellmeier& glass, double wavelength_nm) {
  const double l2 = square_of_micrometres(wavelength_nm);
  double n2 = 1;
  for (std::size_t i = 0; i < glass.b.size(); ++i) n2 += glass.b[i] * l2 / (l2 - glass.c_um2[i]);
  return std::sqrt(n2);
}

double index_at(const Cauchy& glass, double wavelength_nm) {
  const double l2 = square_of_micrometres(wavelength_nm);
  return glass.a + (glass.b + (glass.c + glass.d / l2) / l2) / l2;
}

double index_at(const Spectrum& spectrum, double wavelength_nm) { return value_at(spectrum, wavelength_nm); }

bool is_dispersive(const Spectrum& spectrum) { return !is_constant(spectrum); }

bool is_dispersive(const Cauchy& glass) { return glass.b != 0 || glass.c != 0 || glass.d != 0; }

// A resonance at wavelength 0 adds a constant.
bool is_dispersive(const Sellmeier& glass) {
  for (std::size_t i = 0; i < glass.b.size(); ++i)
    if (glass.b[i] != 0 && glass.c_um2[i] != 0) return true;
  return false;
}

}  // namespace

double index_at(const RefractiveIndex& index, double wavelength_nm) {
  return std::visit([&](const auto& formula) { return index_at(formula, wavelength_nm); }, index);
}

bool is_dispersive(const RefractiveIndex& index) {
  return std::visit([](const auto& formula) { return is_dispersive(formula); }, index);
}

double smallest_index(const RefractiveIndex& index) {
  double smallest = index_at(index, kShortestLight_nm);
  for (double nm = kShortestLight_nm; nm <= kLongestSeen_nm; nm += 1) {
    const double n = index_at(index, nm);
    if (std::isnan(n)) return n;
    smallest = std::min(smallest, n);
  }
  return smallest;
}

std::complex<double> index_at(const MetalIndex& metal, double wavelength_nm) {
  return {value_at(metal.n, wavelength_nm), value_at(metal.k, wavelength_nm)};
}

}  // namespace orbs::spectra

#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

/// Spectra, colours and refractive indices. Wavelengths are nanometres in vacuum everywhere; tables measured
/// in air are used as they are (the two differ by 0.03 %, 0.15 nm in the middle of the visible range).
namespace orbs::spectra {

/// What the eye sees, and with it the wavelengths at which a camera looks.
constexpr double kShortestSeen_nm = 360;
constexpr double kLongestSeen_nm = 830;
/// Fluorescence takes paths to wavelengths below those seen; nothing here describes light below this one.
constexpr double kShortestLight_nm = 300;

/// Beyond its first and last sample a measured reflectance or index keeps its end value, a light or an
/// observer is taken to be dark.
enum class Beyond { HoldsEnds, IsZero };

/// A function of the wavelength, linear between its samples. A constant is one value without a wavelength.
struct Spectrum {
  std::vector<double> wavelengths_nm;  // ascending
  std::vector<double> values{0};       // one for each wavelength
  Beyond beyond = Beyond::HoldsEnds;
  double step_nm = 0;  // where all samples lie at the same distance: that distance; else 0
  bool operator==(const Spectrum&) const = default;
};

Spectrum constant(double value);

/// InputError when there is no sample, the counts differ, a number is not finite, or the wavelengths do not
/// ascend; it names the sample, counted from 1.
Spectrum tabulated(std::vector<double> wavelengths_nm, std::vector<double> values, Beyond beyond);

/// Index of the last sample at or before the wavelength, which must lie strictly between the first and the
/// last.
inline std::size_t sample_before(const Spectrum& spectrum, double wavelength_nm) {
  const auto& at = spectrum.wavelengths_nm;
  if (spectrum.step_nm > 0)  // rounding may take the quotient to the last sample
    return std::min(static_cast<std::size_t>((wavelength_nm - at.front()) / spectrum.step_nm), at.size() - 2);
  return static_cast<std::size_t>(std::upper_bound(at.begin(), at.end(), wavelength_nm) - at.begin()) - 1;
}

inline double value_at(const Spectrum& spectrum, double wavelength_nm) {
  const auto& at = spectrum.wavelengths_nm;
  const auto& values = spectrum.values;
  if (at.empty()) return values.front();
  if (wavelength_nm > at.front() && wavelength_nm < at.back()) {
    const std::size_t i = sample_before(spectrum, wavelength_nm);
    const double share = (wavelength_nm - at[i]) / (at[i + 1] - at[i]);
    return values[i] + share * (values[i + 1] - values[i]);
  }
  const bool is_outside = wavelength_nm < at.front() || wavelength_nm > at.back();
  if (is_outside && spectrum.beyond == Beyond::IsZero) return 0;
  return wavelength_nm <= at.front() ? values.front() : values.back();
}

Spectrum scaled(Spectrum spectrum, double factor);

/// The same value at every wavelength that light of ours can have (kShortestLight_nm to kLongestSeen_nm).
bool is_constant(const Spectrum& spectrum);

/// Integral of the product of up to three spectra over [from_nm, to_nm]. Exact but for rounding: between the
/// samples of all three the product is a cubic, which Gauss's rule with two points integrates exactly.
double integral_of_product(
    const Spectrum& a, const Spectrum& b, const Spectrum& c, double from_nm, double to_nm);

}  // namespace orbs::spectra

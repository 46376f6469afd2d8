#include "spectra/spectrum.h"

#include "base/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace orbs::spectra {

namespace {

// Distance of the samples, 0 when it differs. Tables are written in decimals, hence the rounding that is
// allowed.
double regular_step(const std::vector<double>& wavelengths_nm) {
  if (wavelengths_nm.size() < 2) return 0;
  const double intervals = static_cast<double>(wavelengths_nm.size() - 1);
  const double step = (wavelengths_nm.back() - wavelengths_nm.front()) / intervals;
  for (std::size_t i = 0; i < wavelengths_nm.size(); ++i)
    if (std::abs(wavelengths_nm[i] - (wavelengths_nm.front() + step * static_cast<double>(i))) > 1e-9)
      return 0;
  return step;
}

}  // namespace

Spectrum constant(double value) { return {.wavelengths_nm = {}, .values = {value}}; }

Spectrum tabulated(std::vector<double> wavelengths_nm, std::vector<double> values, Beyond beyond) {
  if (wavelengths_nm.empty()) throw InputError("a spectrum needs at least one sample, has none");
  if (wavelengths_nm.size() != values.size())
    throw InputError(
        fmt::format("a spectrum needs one value for each wavelength, has {} wavelengths and {} values",
                    wavelengths_nm.size(), values.size()));
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(wavelengths_nm[i]) || !std::isfinite(values[i]))
      throw InputError(fmt::format("sample {} of the spectrum must be finite, is {} at {} nm", i + 1,
                                   values[i], wavelengths_nm[i]));
    if (i > 0 && !(wavelengths_nm[i] > wavelengths_nm[i - 1]))
      throw InputError(
          fmt::format("the wavelengths of a spectrum must ascend: sample {} at {} nm follows {} nm", i + 1,
                      wavelengths_nm[i], wavelengths_nm[i - 1]));
  }
  const double step = regular_step(wavelengths_nm);
  return {std::move(wavelengths_nm), std::move(values), beyond, step};
}

Spectrum scaled(Spectrum spectrum, double factor) {
  for (double& value : spectrum.values) value *= factor;
  return spectrum;
}

bool is_constant(const Spectrum& spectrum) {
  const double first = value_at(spectrum, kShortestLight_nm);
  if (value_at(spectrum, kLongestSeen_nm) != first) return false;
  const auto& at = spectrum.wavelengths_nm;
  for (std::size_t i = 0; i < at.size(); ++i)
    if (at[i] >= kShortestLight_nm && at[i] <= kLongestSeen_nm && spectrum.values[i] != first) return false;
  return true;
}

double integral_of_product(
    const Spectrum& a, const Spectrum& b, const Spectrum& c, double from_nm, double to_nm) {
  std::vector<double> ends{from_nm, to_nm};
  for (const Spectrum* factor : {&a, &b, &c})
    for (const double at : factor->wavelengths_nm)
      if (at > from_nm && at < to_nm) ends.push_back(at);
  std::sort(ends.begin(), ends.end());
  static const double gauss = std::sqrt(1.0 / 12);  // distance of the two points from the middle of [0, 1]
  double sum = 0;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const double width = ends[i] - ends[i - 1];
    for (const double share : {0.5 - gauss, 0.5 + gauss}) {
      const double at = ends[i - 1] + share * width;
      sum += 0.5 * width * value_at(a, at) * value_at(b, at) * value_at(c, at);
    }
  }
  return sum;
}

}  // namespace orbs::spectra

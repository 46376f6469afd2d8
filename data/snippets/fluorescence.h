#pragma once

// Fluorescence: a surface that absorbs light at one wavelength and emits it at another. Free to copy into any
// renderer: C++20, the standard library only.
//
// A diffuse surface with reflectance r and re-radiation kernel K emits at the wavelength lo
//   L(lo) = (r(lo) E(lo) + integral of K(li -> lo) E(li) dli) / pi,
// with E the irradiance per nm. K is per nm of lo, for energy (not for photons). A path from the camera knows
// lo and needs li: sample_absorbed samples it with a pdf proportional to K, so that the weight K / pdf is the
// same for every li.
//
// K is given in two forms: as the minimum of two tents, one over absorbed and one over emitted wavelengths,
// or as a matrix over equal bins of wavelength, whose diagonal is the plain reflectance (Donaldson 1954,
// "Spectrophotometry of Fluorescent Pigments"). Wilkie et al. 2001, "Combined Rendering of Polarization and
// Fluorescence Effects".

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace snippets {

/// The wavelength at which light was absorbed that leaves at another. `pdf` is per nm of the absorbed
/// wavelength, `weight` is K / pdf; both are 0 if nothing is emitted at that wavelength.
template <typename Real>
struct AbsorbedSample {
  Real absorbed_nm = 0;
  Real pdf = 0;
  Real weight = 0;
};

/// K(li -> lo) = peak_per_nm min(tent((li - absorbed_nm) / absorbed_reach_nm), tent((lo - emitted_nm) /
/// emitted_reach_nm)) for lo > li, else 0; tent(x) = max(0, 1 - |x|).
template <typename Real>
struct TentKernel {
  Real peak_per_nm = 0;
  Real absorbed_nm = 0;
  Real absorbed_reach_nm = 1;
  Real emitted_nm = 0;
  Real emitted_reach_nm = 1;
  bool operator==(const TentKernel&) const = default;
};

template <typename Real>
Real tent(Real x) {
  return std::max(Real(0), 1 - std::abs(x));
}

/// Integral of min(tent, cut) from -1 to x; cut in [0, 1].
template <typename Real>
Real cut_tent_integral(Real x, Real cut) {
  if (x <= -1) return 0;
  if (x < cut - 1) return (x + 1) * (x + 1) / 2;
  if (x < 1 - cut) return cut * (x + 1 - cut / 2);
  const Real left = std::max(Real(0), 1 - x);
  return cut * (2 - cut) - left * left / 2;
}

/// The x at which that integral is `area`, in [0, cut (2 - cut)]; cut above 0.
template <typename Real>
Real cut_tent_inverse(Real area, Real cut) {
  if (area < cut * cut / 2) return std::sqrt(2 * area) - 1;
  if (area < cut * (2 - Real(1.5) * cut)) return area / cut + cut / 2 - 1;
  // The maximum is for rounding only: the area is at most the whole.
  return 1 - std::sqrt(std::max(Real(0), 2 * (cut * (2 - cut) - area)));
}

template <typename Real>
Real kernel_at(const TentKernel<Real>& kernel, Real absorbed_nm, Real emitted_nm) {
  if (!(emitted_nm > absorbed_nm)) return 0;
  return kernel.peak_per_nm * std::min(tent((absorbed_nm - kernel.absorbed_nm) / kernel.absorbed_reach_nm),
                                       tent((emitted_nm - kernel.emitted_nm) / kernel.emitted_reach_nm));
}

/// Fraction of the light arriving at this wavelength that is emitted at any: the integral of K over lo.
template <typename Real>
Real emitted_share(const TentKernel<Real>& kernel, Real absorbed_nm) {
  const Real cut = tent((absorbed_nm - kernel.absorbed_nm) / kernel.absorbed_reach_nm);
  const Real from = (absorbed_nm - kernel.emitted_nm) / kernel.emitted_reach_nm;
  return kernel.peak_per_nm * kernel.emitted_reach_nm *
         (cut_tent_integral(Real(1), cut) - cut_tent_integral(from, cut));
}

/// Samples the absorbed wavelength, given u in [0, 1).
template <typename Real>
AbsorbedSample<Real> sample_absorbed(const TentKernel<Real>& kernel, Real emitted_nm, Real u) {
  const Real cut = tent((emitted_nm - kernel.emitted_nm) / kernel.emitted_reach_nm);
  const Real end = std::min(Real(1), (emitted_nm - kernel.absorbed_nm) / kernel.absorbed_reach_nm);
  const Real area = cut_tent_integral(end, cut);
  if (!(area > 0)) return {};
  const Real x = cut_tent_inverse(u * area, cut);
  return {kernel.absorbed_nm + x * kernel.absorbed_reach_nm,
          std::min(tent(x), cut) / (area * kernel.absorbed_reach_nm),
          kernel.peak_per_nm * area * kernel.absorbed_reach_nm};
}

/// Pdf of sample_absorbed, per nm.
template <typename Real>
Real pdf_absorbed(const TentKernel<Real>& kernel, Real absorbed_nm, Real emitted_nm) {
  const Real cut = tent((emitted_nm - kernel.emitted_nm) / kernel.emitted_reach_nm);
  const Real end = std::min(Real(1), (emitted_nm - kernel.absorbed_nm) / kernel.absorbed_reach_nm);
  const Real area = cut_tent_integral(end, cut);
  if (!(area > 0) || !(absorbed_nm < emitted_nm)) return 0;
  return std::min(tent((absorbed_nm - kernel.absorbed_nm) / kernel.absorbed_reach_nm), cut) /
         (area * kernel.absorbed_reach_nm);
}

/// The largest ratio of outgoing to incoming energy, by reflection and emission together, and its wavelength.
/// A ratio above 1 violates energy conservation.
template <typename Real>
struct LargestGain {
  Real gain = 0;
  Real absorbed_nm = 0;
};

/// Evaluated at every nm of the absorbed range; `reflectance` returns r at a wavelength in nm.
template <typename Real, typename Reflectance>
LargestGain<Real> largest_gain(const TentKernel<Real>& kernel, const Reflectance& reflectance) {
  LargestGain<Real> largest;
  const int reach = static_cast<int>(std::ceil(kernel.absorbed_reach_nm));
  for (int i = -reach; i <= reach; ++i) {
    const Real nm = kernel.absorbed_nm + static_cast<Real>(i);
    const Real gain = emitted_share(kernel, nm) + reflectance(nm);
    if (gain > largest.gain) largest = {gain, nm};
  }
  return largest;
}

/// Bins of equal width from first_nm on. share[out * bins + in] is the fraction of the light arriving in bin
/// `in` that leaves in bin `out`; light of the diagonal keeps its wavelength.
template <typename Real>
struct ReradiationMatrix {
  Real first_nm = 0;
  Real width_nm = 1;
  std::size_t bins = 0;
  std::vector<Real> share;
  bool operator==(const ReradiationMatrix&) const = default;
};

/// Index of the bin; `bins` outside the matrix.
template <typename Real>
std::size_t bin_of(const ReradiationMatrix<Real>& matrix, Real wavelength_nm) {
  const Real at = (wavelength_nm - matrix.first_nm) / matrix.width_nm;
  return at >= 0 && at < static_cast<Real>(matrix.bins) ? static_cast<std::size_t>(at) : matrix.bins;
}

/// Fraction of the light arriving in bin `in` that leaves in any; above 1 energy is not conserved.
template <typename Real>
Real emitted_share(const ReradiationMatrix<Real>& matrix, std::size_t in) {
  Real sum = 0;
  for (std::size_t out = 0; out < matrix.bins; ++out) sum += matrix.share[out * matrix.bins + in];
  return sum;
}

/// Samples the absorbed wavelength for one emitted wavelength: a bin with probability proportional to its
/// share, then a wavelength in the bin; in the emitted wavelength's own bin, that wavelength itself. `pdf` is
/// the probability of the bin over its width (for the own bin the probability); `weight` is the sum of the
/// row.
template <typename Real>
AbsorbedSample<Real> sample_absorbed(const ReradiationMatrix<Real>& matrix, Real emitted_nm, Real u) {
  const std::size_t out = bin_of(matrix, emitted_nm);
  if (out == matrix.bins) return {};
  const auto row = matrix.share.begin() + static_cast<std::ptrdiff_t>(out * matrix.bins);
  Real sum = 0;
  std::size_t last =
      matrix.bins;  // the last bin that has a share: rounding must not choose one that has none
  for (std::size_t in = 0; in < matrix.bins; ++in) {
    sum += row[static_cast<std::ptrdiff_t>(in)];
    if (row[static_cast<std::ptrdiff_t>(in)] > 0) last = in;
  }
  if (!(sum > 0)) return {};
  Real rest = u * sum;
  std::size_t in = 0;
  for (; in < last && rest >= row[static_cast<std::ptrdiff_t>(in)]; ++in)
    rest -= row[static_cast<std::ptrdiff_t>(in)];
  const Real share = row[static_cast<std::ptrdiff_t>(in)];
  if (in == out) return {emitted_nm, share / sum, sum};
  // The minimum is for rounding only: the rest is below the share.
  const Real place = std::min(rest / share, Real(1));
  return {matrix.first_nm + (static_cast<Real>(in) + place) * matrix.width_nm,
          share / (sum * matrix.width_nm), sum};
}

}  // namespace snippets

#include "spectra/wavelengths.h"

#include "spectra/observer.h"
#include "spectra/rgb.h"

#include <cmath>
#include <vector>

namespace orbs::spectra {

namespace {

constexpr std::size_t kCells = 1024;

// wavelengths_nm[i] is where the cumulative distribution is i / kCells. It *is* the distribution: the density
// within a cell is constant, so that sampling and density agree exactly, however coarse the sums behind the
// table are.
using InverseDistribution = std::array<float, kCells + 1>;

// The density that the table follows, at each nm, not normalised. Square roots are the same on every machine;
// a free exponent (0.4 would give 10 % less noise) would not be.
std::vector<double> wanted_density() {
  std::vector<double> density;
  for (double nm = kShortestSeen_nm; nm <= kLongestSeen_nm; nm += 1) {
    const RgbMatching matching = rgb_matching_at({static_cast<float>(nm)});
    const Vec3d rgb{matching.red[0], matching.green[0], matching.blue[0]};
    density.push_back(std::sqrt(value_at(illuminant("D65"), nm) * length(rgb)));
  }
  return density;
}

InverseDistribution make_distribution() {
  const std::vector<double> density = wanted_density();
  std::vector<double> below{0};  // integral up to each nm, by the trapezoid rule
  for (std::size_t i = 1; i < density.size(); ++i)
    below.push_back(below.back() + 0.5 * (density[i - 1] + density[i]));
  InverseDistribution table{};
  std::size_t i = 0;
  for (std::size_t cell = 0; cell < kCells; ++cell) {
    const double goal = below.back() * static_cast<double>(cell) / kCells;
    while (below[i + 1] <= goal) ++i;
    const double share = (goal - below[i]) / (below[i + 1] - below[i]);
    table[cell] = static_cast<float>(kShortestSeen_nm + static_cast<double>(i) + share);
  }
  table[kCells] = static_cast<float>(kLongestSeen_nm);
  return table;
}

}  // namespace

Wavelengths sample_wavelengths(float u) {
  static const InverseDistribution table = make_distribution();
  Wavelengths out;
  for (std::size_t k = 0; k < out.nm.size(); ++k) {
    float turned = u + 0.25F * static_cast<float>(k);
    if (turned >= 1) turned -= 1;
    const float at = turned * kCells;
    const auto cell = static_cast<std::size_t>(at);
    const float width = table[cell + 1] - table[cell];
    out.nm[k] = table[cell] + (at - static_cast<float>(cell)) * width;
    out.pdf[k] = 1 / (kCells * width);
  }
  return out;
}

}  // namespace orbs::spectra

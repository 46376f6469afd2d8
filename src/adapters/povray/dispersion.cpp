#include "adapters/povray/dispersion.h"

#include <array>
#include <cmath>

namespace orbs::adapters::povray {

namespace {

// Mean wavelengths of POV-Ray's hues, and of the positive parts of Rec.709's matching functions under D65
// (red without its second lobe in the violet).
struct Hue {
  double in_povray_nm;
  double in_light_nm;
};
constexpr std::array<Hue, 3> kHues{{{474, 453.4}, {582, 539.1}, {650, 608.6}}};

}  // namespace

// Least squares in the logarithm of the index, which is linear in POV-Ray's wavelength.
Dispersion dispersion_of(const scene::Dielectric& glass) {
  constexpr double kCentre_nm = 555;
  constexpr double kRange_nm = 350;
  double sum_x = 0;
  double sum_y = 0;
  double sum_xx = 0;
  double sum_xy = 0;
  for (const Hue& hue : kHues) {
    const double x = (kCentre_nm - hue.in_povray_nm) / kRange_nm;
    const double y =
        std::log(index_at(glass.index, hue.in_light_nm) / index_at(glass.outside, hue.in_light_nm));
    sum_x += x;
    sum_y += y;
    sum_xx += x * x;
    sum_xy += x * y;
  }
  constexpr double kCount = kHues.size();
  const double slope = (kCount * sum_xy - sum_x * sum_y) / (kCount * sum_xx - sum_x * sum_x);
  return {std::exp((sum_y - slope * sum_x) / kCount), std::exp(slope)};
}

}  // namespace orbs::adapters::povray

#pragma once

#include "base/vec.h"
#include "spectra/spectrum.h"

#include <array>
#include <string>
#include <string_view>

namespace orbs::spectra {

/// Colour matching functions of the CIE 1931 2 degree observer, 360 to 830 nm at 1 nm, per nm: scaled so that
/// ybar integrates to 1, a light of value 1 at all wavelengths thus has Y = 1.
struct Observer {
  Spectrum xbar;
  Spectrum ybar;
  Spectrum zbar;
};
const Observer& cie_1931();

constexpr std::array<std::string_view, 4> kIlluminants{"A", "D50", "D65", "E"};

/// The illuminant of that name, 300 to 830 nm, scaled to Y = 1. InputError that lists kIlluminants for any
/// other name.
const Spectrum& illuminant(std::string_view name);

/// XYZ of a light.
Vec3d xyz_of_light(const Spectrum& light);

/// XYZ of a surface with this reflectance under a light; Y of the light's own luminance is a perfect
/// diffuser.
Vec3d xyz_of_reflectance(const Spectrum& reflectance, const Spectrum& light);

}  // namespace orbs::spectra

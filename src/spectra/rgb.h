#pragma once

#include "base/vec.h"
#include "spectra/spectrum.h"

#include <array>

/// Between spectra and linear Rec.709 (the colour space of all images here). Its white is illuminant D65 as
/// tabulated, integrated like everything else, so that D65 is exactly (1, 1, 1); the rounded chromaticity
/// (0.3127, 0.3290) that the standard prints would make it (1.00016, 0.99998, 0.99976).
namespace orbs::spectra {

Vec3d rgb_of_xyz(Vec3d xyz);

/// A reflectance that has the colour `rgb` under D65: r, g and b times three fixed smooth reflectances which
/// sum to 1 (data/common/spectra/make_rgb_basis.py). Linear, hence exact for colours of any size and sign;
/// within [0, 1] for colours within [0, 1]; grey is constant.
Spectrum reflectance_of_rgb(Vec3d rgb);

/// What that reflectance is made of, and D65 (Y = 1), at four wavelengths.
struct RgbBasis {
  std::array<float, 4> red;
  std::array<float, 4> blue;
  std::array<float, 4> d65;
};
RgbBasis rgb_basis_at(const std::array<float, 4>& wavelengths_nm);

/// reflectance_of_rgb(rgb) at the wavelengths of the basis. Written around green, 1 - red - blue, so that
/// grey is the same number at every wavelength.
inline std::array<float, 4> reflectances(Vec3f rgb, const RgbBasis& basis) {
  std::array<float, 4> out{};
  for (std::size_t i = 0; i < 4; ++i)
    out[i] = rgb.y + (rgb.x - rgb.y) * basis.red[i] + (rgb.z - rgb.y) * basis.blue[i];
  return out;
}

/// The light of colour `rgb`: that reflectance times D65. White is D65.
inline std::array<float, 4> lights(Vec3f rgb, const RgbBasis& basis) {
  std::array<float, 4> out = reflectances(rgb, basis);
  for (std::size_t i = 0; i < 4; ++i) out[i] *= basis.d65[i];
  return out;
}

/// Linear Rec.709 of light of value 1 per nm at each of four wavelengths alone; zero outside of what is seen.
struct RgbMatching {
  std::array<float, 4> red;
  std::array<float, 4> green;
  std::array<float, 4> blue;
};
RgbMatching rgb_matching_at(const std::array<float, 4>& wavelengths_nm);

}  // namespace orbs::spectra

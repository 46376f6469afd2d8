#pragma once

#include <array>
#include <span>

/// The tables of data/common/spectra that every spectral image needs, compiled in by
/// cmake/embed_table.cmake. The first column is the wavelength in nm, the others are as the header of the
/// file names them.
namespace orbs::spectra {

std::span<const std::array<double, 4>> cie_1931_rows();    // 360 to 830 nm by 1: xbar, ybar, zbar
std::span<const std::array<double, 5>> illuminant_rows();  // 300 to 830 nm by 5: A, D50, D65, E
std::span<const std::array<double, 4>> rgb_basis_rows();   // 360 to 830 nm by 5: red, green, blue

}  // namespace orbs::spectra

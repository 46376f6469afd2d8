#pragma once

#include "base/vec.h"

#include <functional>
#include <string>

/// Colours by plain sums over wavelengths in double, from the table files and independent of src/spectra: the
/// expectations of the tests of spectral images.
namespace orbs::tests {

using OfWavelength = std::function<double(double nm)>;

/// A column of a table in data/common/spectra, linear between its rows; outside them its end values, or zero.
OfWavelength table_column(const std::string& file, const std::string& column, bool holds_ends);

/// X, Y and Z of light per nm; equal-energy light of 1 has Y = 1.
Vec3d xyz_by_sum(const OfWavelength& light);

/// The same in linear Rec.709 whose white is D65.
Vec3d rgb_by_sum(const OfWavelength& light);

/// "D65" or "D50", scaled to Y = 1.
OfWavelength illuminant_by_table(const std::string& name);

/// X, Y and Z of a linear Rec.709 colour, and Y alone.
Vec3d xyz_of_rgb_by_sum(Vec3d rgb);
double luminance_by_sum(Vec3d rgb);

}  // namespace orbs::tests

#pragma once

#include "base/vec.h"

#include <array>
#include <complex>

/// Polarised light by what it is: the electric field as a vector in space, followed through surfaces by
/// Fresnel's formulas, in double. No Mueller matrix and no reference frame before the eye: what the tests of
/// polarised images expect.
namespace orbs::tests {

using Complex = std::complex<double>;

/// Amplitude of exp(-i w t).
struct Field {
  std::array<Complex, 3> e;
};

/// Unpolarised light is the sum of two such beams that know nothing of each other.
struct Beam {
  Vec3d direction;  // of travel
  std::array<Field, 2> fields;
};

/// Of radiance 1.
Beam unpolarised(Vec3d direction);

/// At a plane with unit normal (either sign); `index` beyond over that on this side.
Beam reflected(const Beam& beam, Vec3d normal, Complex index);
/// A perfect conductor.
Beam mirrored(const Beam& beam, Vec3d normal);
/// Behind a polariser that lets the field along `axis` pass.
Beam polarised_along(const Beam& beam, Vec3d axis);
/// Both fields times a factor.
Beam dimmed(const Beam& beam, double amplitude);

/// S0 to S3 for an eye that has `right` to its right.
std::array<double, 4> stokes_of(const Beam& beam, Vec3d right);

}  // namespace orbs::tests

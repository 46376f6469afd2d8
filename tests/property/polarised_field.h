#pragma once

#include "base/vec.h"

#include <array>
#include <complex>

/// Polarised light as its electric field, a vector in space that surfaces change by Fresnel's equations, in
/// double. It needs no Mueller matrix and no reference frame before the camera: the expectations of the tests
/// of polarised images.
namespace orbs::tests {

using Complex = std::complex<double>;

/// Amplitude of exp(-i w t).
struct Field {
  std::array<Complex, 3> e;
};

/// Unpolarised light is the sum of two such beams that are incoherent.
struct Beam {
  Vec3d direction;  // of travel
  std::array<Field, 2> fields;
};

/// With radiance 1.
Beam unpolarised(Vec3d direction);

/// At a plane with unit normal (either sign); `index` beyond over that on this side.
Beam reflected(const Beam& beam, Vec3d normal, Complex index);
/// A perfect conductor.
Beam mirrored(const Beam& beam, Vec3d normal);
/// After a polariser that transmits the field along `axis`.
Beam polarised_along(const Beam& beam, Vec3d axis);
/// Both fields multiplied by a factor.
Beam dimmed(const Beam& beam, double amplitude);

/// S0 to S3 for a viewer who has `right` to the right.
std::array<double, 4> stokes_of(const Beam& beam, Vec3d right);

}  // namespace orbs::tests

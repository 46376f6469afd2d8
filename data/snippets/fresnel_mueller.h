#pragma once

// Polarised light at smooth surfaces, polarisers and retarders: Fresnel amplitudes with their phase, and
// Mueller matrices. Free to copy into any renderer: C++20, the standard library only.
//
// Conventions
//   light     A Stokes vector refers to a frame (x, y, d): d is the direction of propagation, x the
//             reference direction across it, and y = d cross x. To a viewer who faces the source, x points
//             to the right and y up.
//   S0 .. S3  S0 is the radiance. S1 > 0: polarised along x. S2 > 0: polarised along x + y, at +45 degrees
//             (right and up for that viewer). S3 > 0: right-circular in the sense of optics, that is, the
//             field rotates clockwise for that viewer.
//   fields    They vary as exp(-i w t); an absorbing medium has the index n + i k with k > 0.
//             S1 = |Ex|^2 - |Ey|^2, S2 + i S3 = 2 Ex conj(Ey).
//   surfaces  The frames of the incident, reflected and transmitted beam share the axis x, which is
//             perpendicular to the plane of incidence (s); each has y = d cross x (p). Hence r_p = -r_s at
//             normal incidence, and a mirror reflects right-circular light as left-circular.
//   paths     The outgoing light is M S. A path from the camera carries the row vector
//             (1, 0, 0, 0) M1 M2 ... and multiplies it by the Stokes vector of the light at its end.
//
// Formulas: Born and Wolf, "Principles of Optics", 7th edition, 1.5.2 to 1.5.4 and 14.2; Goldstein,
// "Polarized Light", 3rd edition, chapters 5, 6 and 8, whose signs differ because of exp(-i w t) here.

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>

namespace snippets {

template <typename Real>
using Stokes = std::array<Real, 4>;

/// m[row][column]; rows belong to the outgoing light.
template <typename Real>
struct Mueller {
  std::array<std::array<Real, 4>, 4> m{};
};

/// Mueller matrix of an element that multiplies the field along x by one amplitude and that along y by
/// another: a surface in its own frames, an aligned polariser or retarder. Four numbers instead of sixteen:
///   [ mean half 0 0; half mean 0 0; 0 0 real -imaginary; 0 0 imaginary real ].
template <typename Real>
struct AlignedMueller {
  Real mean{};  // (|ax|^2 + |ay|^2) / 2: the factor for unpolarised light
  Real half{};  // (|ax|^2 - |ay|^2) / 2
  Real real{};  // of ax conj(ay)
  Real imaginary{};
};

template <typename Real>
AlignedMueller<Real> aligned_mueller(std::complex<Real> along_x, std::complex<Real> along_y) {
  const Real x = std::norm(along_x);
  const Real y = std::norm(along_y);
  const std::complex<Real> mixed = along_x * std::conj(along_y);
  return {(x + y) / 2, (x - y) / 2, mixed.real(), mixed.imag()};
}

template <typename Real>
AlignedMueller<Real> operator*(AlignedMueller<Real> a, Real factor) {
  return {a.mean * factor, a.half * factor, a.real * factor, a.imaginary * factor};
}

/// The product M s.
template <typename Real>
Stokes<Real> operator*(const AlignedMueller<Real>& a, const Stokes<Real>& s) {
  return {a.mean * s[0] + a.half * s[1], a.half * s[0] + a.mean * s[1], a.real * s[2] - a.imaginary * s[3],
          a.imaginary * s[2] + a.real * s[3]};
}

/// The product row M.
template <typename Real>
Stokes<Real> row_times(const Stokes<Real>& row, const AlignedMueller<Real>& a) {
  return {row[0] * a.mean + row[1] * a.half, row[0] * a.half + row[1] * a.mean,
          row[2] * a.real + row[3] * a.imaginary, row[3] * a.real - row[2] * a.imaginary};
}

template <typename Real>
Mueller<Real> full(const AlignedMueller<Real>& a) {
  return {{{{a.mean, a.half, 0, 0},
            {a.half, a.mean, 0, 0},
            {0, 0, a.real, -a.imaginary},
            {0, 0, a.imaginary, a.real}}}};
}

template <typename Real>
Mueller<Real> operator*(const Mueller<Real>& a, const Mueller<Real>& b) {
  Mueller<Real> product;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t j = 0; j < 4; ++j) product.m[i][j] += a.m[i][k] * b.m[k][j];
  return product;
}

template <typename Real>
Stokes<Real> operator*(const Mueller<Real>& a, const Stokes<Real>& s) {
  Stokes<Real> out{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) out[i] += a.m[i][j] * s[j];
  return out;
}

template <typename Real>
Stokes<Real> row_times(const Stokes<Real>& row, const Mueller<Real>& a) {
  Stokes<Real> out{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) out[j] += row[i] * a.m[i][j];
  return out;
}

/// Cosine and sine, of a float too by the functions for double: those for floats are not the same in all
/// libraries, and so would images not be.
template <typename Real>
Real cos_of(Real angle_rad) {
  return static_cast<Real>(std::cos(static_cast<double>(angle_rad)));
}

template <typename Real>
Real sin_of(Real angle_rad) {
  return static_cast<Real>(std::sin(static_cast<double>(angle_rad)));
}

/// Rotation of the reference frame of a Stokes vector: the new x axis is the old one rotated towards the old
/// y. Cosine and sine are of twice the angle.
template <typename Real>
struct FrameTurn {
  Real cos2 = 1;
  Real sin2 = 0;
};

template <typename Real>
FrameTurn<Real> frame_turn(Real angle_rad) {
  return {cos_of(2 * angle_rad), sin_of(2 * angle_rad)};
}

/// Rotation from the reference direction `from` to `to`, unit vectors perpendicular to the unit direction of
/// propagation d. V is any struct with x, y and z.
template <typename V>
auto frame_turn_between(V from, V to, V d) {
  const auto cosine = from.x * to.x + from.y * to.y + from.z * to.z;
  const auto sine = d.x * (from.y * to.z - from.z * to.y) + d.y * (from.z * to.x - from.x * to.z) +
                    d.z * (from.x * to.y - from.y * to.x);
  return FrameTurn<decltype(+from.x)>{cosine * cosine - sine * sine, 2 * cosine * sine};
}

/// The Stokes vector in the rotated frame.
template <typename Real>
Stokes<Real> operator*(FrameTurn<Real> turn, const Stokes<Real>& s) {
  return {s[0], turn.cos2 * s[1] + turn.sin2 * s[2], turn.cos2 * s[2] - turn.sin2 * s[1], s[3]};
}

template <typename Real>
Stokes<Real> row_times(const Stokes<Real>& row, FrameTurn<Real> turn) {
  return {row[0], turn.cos2 * row[1] - turn.sin2 * row[2], turn.cos2 * row[2] + turn.sin2 * row[1], row[3]};
}

template <typename Real>
Mueller<Real> full(FrameTurn<Real> turn) {
  return {{{{1, 0, 0, 0}, {0, turn.cos2, turn.sin2, 0}, {0, -turn.sin2, turn.cos2, 0}, {0, 0, 0, 1}}}};
}

/// Mueller matrix, in the frame of the light, of an element whose x axis is rotated by `turn` from it.
template <typename Real>
Mueller<Real> turned(const AlignedMueller<Real>& element, FrameTurn<Real> turn) {
  return full(FrameTurn<Real>{turn.cos2, -turn.sin2}) * full(element) * full(turn);
}

/// Ideal polariser that transmits the field along x.
template <typename Real>
AlignedMueller<Real> polariser_along_x() {
  return {Real(0.5), Real(0.5), 0, 0};
}

/// Retarder whose fast axis is x: it delays the field along y by `retardance_rad`. A quarter-wave plate
/// (pi / 2) converts light polarised at +45 degrees to left-circular light.
template <typename Real>
AlignedMueller<Real> retarder_fast_along_x(Real retardance_rad) {
  return {1, 0, cos_of(retardance_rad), -sin_of(retardance_rad)};
}

/// Amplitudes of a wave incident from a dielectric on the boundary to another medium.
template <typename Real>
struct FresnelAmplitudes {
  std::complex<Real> s;
  std::complex<Real> p;
};

/// a / b as a conj(b) / |b|^2, with one real division. The complex division of the standard library guards
/// against overflow, which indices cannot reach, and takes twice the time.
template <typename Real>
std::complex<Real> quotient(std::complex<Real> a, std::complex<Real> b) {
  return a * std::conj(b) * (1 / std::norm(b));
}

/// Square root with non-negative real and imaginary part, for w with a non-negative imaginary part: the
/// normal component of a propagating or evanescent wave. It takes a third of the time of std::sqrt, which
/// handles infinities.
template <typename Real>
std::complex<Real> wave_root(std::complex<Real> w) {
  const Real large = std::sqrt((std::sqrt(std::norm(w)) + std::abs(w.real())) / 2);
  const Real small = large > 0 ? w.imag() / (2 * large) : 0;
  return w.real() >= 0 ? std::complex<Real>(large, small) : std::complex<Real>(small, large);
}

/// index * cos(refracted angle): the normal component of the wave vector beyond the boundary, divided by the
/// wave number on the side of incidence. Imaginary beyond the critical angle. `index` is the index beyond
/// the boundary over the (real) index on the side of incidence; cos_i in [0, 1].
template <typename Real>
std::complex<Real> normal_wave(Real cos_i, std::complex<Real> index) {
  return wave_root(index * index - (1 - cos_i) * (1 + cos_i));
}

/// Reflected amplitude at a boundary, from the admittances of both media up to a common factor: the normal
/// component of the wave vector for s; the squared index divided by it for p, with both media swapped to
/// obtain the sign stated above.
template <typename Real>
std::complex<Real> boundary_reflection(std::complex<Real> near, std::complex<Real> far) {
  return quotient(near - far, near + far);
}

/// Reflected over incident field. |s|^2 and |p|^2 are the reflectances. At total internal reflection both are
/// 1, and the phases matter.
template <typename Real>
FresnelAmplitudes<Real> fresnel_reflection(Real cos_i, std::complex<Real> index) {
  const std::complex<Real> beyond = normal_wave(cos_i, index);
  return {boundary_reflection(std::complex<Real>(cos_i), beyond),
          boundary_reflection(index * index * cos_i, beyond)};
}

template <typename Real>
AlignedMueller<Real> reflection_mueller(Real cos_i, std::complex<Real> index) {
  const FresnelAmplitudes<Real> r = fresnel_reflection(cos_i, index);
  return aligned_mueller(r.s, r.p);
}

/// Mueller matrix of transmission into a dielectric, for power (flux across the boundary): `mean` is 1 minus
/// that of the reflection, zero beyond the critical angle. The scaling of radiance by index^2 is left to the
/// renderer.
template <typename Real>
AlignedMueller<Real> transmission_mueller(Real cos_i, Real index) {
  const Real square = index * index - (1 - cos_i) * (1 + cos_i);
  if (square <= 0 || cos_i <= 0) return {};
  const Real beyond = std::sqrt(square);
  const Real s = 2 * cos_i / (cos_i + beyond);
  const Real p = 2 * index * cos_i / (index * index * cos_i + beyond);
  return aligned_mueller(std::complex<Real>(s), std::complex<Real>(p)) * (beyond / cos_i);
}

/// Degree of polarisation: 0 to 1 for physical light; 0 without light.
template <typename Real>
Real degree_of_polarisation(const Stokes<Real>& s) {
  return s[0] > 0 ? std::sqrt(s[1] * s[1] + s[2] * s[2] + s[3] * s[3]) / s[0] : 0;
}

}  // namespace snippets

#pragma once

// What smooth surfaces, polarisers and retarders do to polarised light: Fresnel amplitudes with their phase,
// and Mueller matrices. Free to copy into any renderer: C++20, the standard library only.
//
// Conventions, all of them
//   light       A Stokes vector belongs to a frame (x, y, d): d is the direction in which the light travels,
//   x the
//               reference direction across it, y = d cross x. Seen by who looks at the oncoming light, x
//               points to the right and y up.
//   S0 .. S3    S0 radiance. S1 > 0: polarised along x. S2 > 0: along x + y, +45 degrees (right and up for
//   that viewer).
//               S3 > 0: right-circular in the sense of optics: for that viewer the field turns clockwise.
//   fields      vary as exp(-i w t); an absorbing medium has the index n + i k with k > 0.
//               S1 = |Ex|^2 - |Ey|^2, S2 + i S3 = 2 Ex conj(Ey).
//   surfaces    The frames of the incident, reflected and transmitted beam share x = the direction
//   perpendicular to the
//               plane of incidence (s); each has y = d cross x (p). At normal incidence r_p = -r_s therefore,
//               a mirror turns right-circular light into left-circular.
//   paths       light comes out as M S; who walks from the camera carries the row vector (1, 0, 0, 0) M1 M2
//   ... and
//               multiplies it with the Stokes vector of the light at the end.
//
// Formulas: Born and Wolf, "Principles of Optics", 7th edition, 1.5.2 to 1.5.4 and 14.2; Goldstein,
// "Polarized Light", 3rd edition, chapters 5, 6 and 8, of which the signs here differ by the choice of exp(-i
// w t).

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>

namespace snippets {

template <typename Real>
using Stokes = std::array<Real, 4>;

/// m[row][column]: rows are of the light that comes out.
template <typename Real>
struct Mueller {
  std::array<std::array<Real, 4>, 4> m{};
};

/// The Mueller matrix of whatever multiplies the field along x by one amplitude and that along y by another:
/// a surface in its own frames, an aligned polariser or retarder. Four numbers instead of sixteen:
///   [ mean half 0 0; half mean 0 0; 0 0 real -imaginary; 0 0 imaginary real ].
template <typename Real>
struct AlignedMueller {
  Real mean{};  // (|ax|^2 + |ay|^2) / 2: what becomes of unpolarised light
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

/// M s.
template <typename Real>
Stokes<Real> operator*(const AlignedMueller<Real>& a, const Stokes<Real>& s) {
  return {a.mean * s[0] + a.half * s[1], a.half * s[0] + a.mean * s[1], a.real * s[2] - a.imaginary * s[3],
          a.imaginary * s[2] + a.real * s[3]};
}

/// row M.
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

/// Another reference direction for the same light: the new x is the old one turned towards the old y. The
/// angle enters doubled, as cosine and sine.
template <typename Real>
struct FrameTurn {
  Real cos2 = 1;
  Real sin2 = 0;
};

template <typename Real>
FrameTurn<Real> frame_turn(Real angle_rad) {
  return {std::cos(2 * angle_rad), std::sin(2 * angle_rad)};
}

/// From the reference direction `from` to `to`, unit vectors across the unit direction of travel d. V is any
/// struct with x, y and z.
template <typename V>
auto frame_turn_between(V from, V to, V d) {
  const auto cosine = from.x * to.x + from.y * to.y + from.z * to.z;
  const auto sine = d.x * (from.y * to.z - from.z * to.y) + d.y * (from.z * to.x - from.x * to.z) +
                    d.z * (from.x * to.y - from.y * to.x);
  return FrameTurn<decltype(+from.x)>{cosine * cosine - sine * sine, 2 * cosine * sine};
}

/// The same light in the turned frame.
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

/// An element whose own x axis lies at `turn` from the frame of the light, seen in that frame.
template <typename Real>
Mueller<Real> turned(const AlignedMueller<Real>& element, FrameTurn<Real> turn) {
  return full(FrameTurn<Real>{turn.cos2, -turn.sin2}) * full(element) * full(turn);
}

/// Ideal polariser that lets the field along x pass.
template <typename Real>
AlignedMueller<Real> polariser_along_x() {
  return {Real(0.5), Real(0.5), 0, 0};
}

/// Retarder whose fast axis is x: the field along y falls behind by `retardance_rad`. A quarter wave (pi / 2)
/// turns +45 degree light into left-circular light.
template <typename Real>
AlignedMueller<Real> retarder_fast_along_x(Real retardance_rad) {
  return {1, 0, std::cos(retardance_rad), -std::sin(retardance_rad)};
}

/// Amplitudes of a wave that meets the surface between a dielectric and another medium.
template <typename Real>
struct FresnelAmplitudes {
  std::complex<Real> s;
  std::complex<Real> p;
};

/// a / b as a conj(b) / |b|^2: one real division. Complex division guards against overflow that indices
/// cannot reach, and takes twice the time.
template <typename Real>
std::complex<Real> quotient(std::complex<Real> a, std::complex<Real> b) {
  return a * std::conj(b) * (1 / std::norm(b));
}

/// Square root with real and imaginary part at least 0, for w with an imaginary part of at least 0: the
/// normal component of a wave that travels on or fades. A third of the time of std::sqrt, which handles all
/// the infinities.
template <typename Real>
std::complex<Real> wave_root(std::complex<Real> w) {
  const Real large = std::sqrt((std::sqrt(std::norm(w)) + std::abs(w.real())) / 2);
  const Real small = large > 0 ? w.imag() / (2 * large) : 0;
  return w.real() >= 0 ? std::complex<Real>(large, small) : std::complex<Real>(small, large);
}

/// Normal component of the wave vector beyond the surface, over that in vacuum times the index on the side of
/// incidence: index cos of the refracted angle. Imaginary beyond the critical angle. `index` = index beyond
/// over the (real) index on the side of incidence; cos_i in [0, 1].
template <typename Real>
std::complex<Real> normal_wave(Real cos_i, std::complex<Real> index) {
  return wave_root(index * index - (1 - cos_i) * (1 + cos_i));
}

/// Reflected field where a wave passes from one medium into another, from the admittances of the two up to a
/// common factor: for s the normal component of the wave vector, for p, with the two swapped to get the sign
/// stated above, the squared index over it.
template <typename Real>
std::complex<Real> boundary_reflection(std::complex<Real> near, std::complex<Real> far) {
  return quotient(near - far, near + far);
}

/// Reflected over incident field. |s|^2 and |p|^2 are the reflectances, 1 at total internal reflection, where
/// the phases remain.
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

/// Of power (flux across the surface) into a dielectric: mean is 1 minus that of the reflection; zero beyond
/// the critical angle. Radiance grows by index^2 on top of it, which is the renderer's to apply or not.
template <typename Real>
AlignedMueller<Real> transmission_mueller(Real cos_i, Real index) {
  const Real square = index * index - (1 - cos_i) * (1 + cos_i);
  if (square <= 0 || cos_i <= 0) return {};
  const Real beyond = std::sqrt(square);
  const Real s = 2 * cos_i / (cos_i + beyond);
  const Real p = 2 * index * cos_i / (index * index * cos_i + beyond);
  return aligned_mueller(std::complex<Real>(s), std::complex<Real>(p)) * (beyond / cos_i);
}

/// Share of the light that is polarised: 0 to 1 for light that exists; 0 where there is none.
template <typename Real>
Real degree_of_polarisation(const Stokes<Real>& s) {
  return s[0] > 0 ? std::sqrt(s[1] * s[1] + s[2] * s[2] + s[3] * s[3]) / s[0] : 0;
}

}  // namespace snippets

#pragma once

// Iridescence: a thin film on a metal or a dielectric, with all interreflections inside the film and their
// phases (Airy sum), for each polarisation. Free to copy into any renderer together with fresnel_mueller.h,
// whose conventions apply: C++20, the standard library only.
//
//   outside (real index, usually 1) | film (real or absorbing) | base (real or absorbing)
//
// The amplitudes are for one wavelength. An RGB renderer must integrate the reflectance over the spectrum
// first, because three wavelengths alias.
//
// Born and Wolf, "Principles of Optics", 7th edition, 1.6.4 (eq. 57 to 60) and 14.4.

#include "fresnel_mueller.h"

#include <cmath>
#include <complex>
#include <numbers>

namespace snippets {

template <typename Real>
struct ThinFilm {
  Real outside_index = 1;
  std::complex<Real> film_index;
  std::complex<Real> base_index;
  Real height_nm = 0;
};

/// Normal components of the wave vector (divided by 2 pi / vacuum wavelength) in the three media, and the
/// phase of one pass through the film.
template <typename Real>
struct FilmWaves {
  std::complex<Real> outside;
  std::complex<Real> film;
  std::complex<Real> base;
  std::complex<Real> through;  // exp(i k_z height)
};

/// cos_i in (0, 1], in the outer medium.
template <typename Real>
FilmWaves<Real> film_waves(const ThinFilm<Real>& film, Real cos_i, Real wavelength_nm) {
  const Real n2 = film.outside_index * film.outside_index;
  // The squared tangential component is the same in all three media.
  const Real across2 = n2 * (1 - cos_i) * (1 + cos_i);
  FilmWaves<Real> waves;
  waves.outside = film.outside_index * cos_i;
  waves.film = wave_root(film.film_index * film.film_index - across2);
  waves.base = wave_root(film.base_index * film.base_index - across2);
  const Real turn = 2 * std::numbers::pi_v<Real> * film.height_nm / wavelength_nm;
  // In double for floats too: the functions for floats are not the same in all libraries.
  waves.through =
      std::complex<Real>(std::exp(std::complex<double>(std::complex<Real>(0, turn) * waves.film)));
  return waves;
}

/// Reflected over incident field. |s|^2 and |p|^2 are the reflectances. NaN (0 / 0) at the single angle at
/// which a wave propagates exactly along a film whose index is below that of the outer medium.
template <typename Real>
FresnelAmplitudes<Real> film_reflection(const ThinFilm<Real>& film, Real cos_i, Real wavelength_nm) {
  using Complex = std::complex<Real>;
  const FilmWaves<Real> waves = film_waves(film, cos_i, wavelength_nm);
  const Complex twice = waves.through * waves.through;
  const auto sum = [&](Complex top, Complex bottom) {
    return quotient(top + bottom * twice, Real(1) + top * bottom * twice);
  };
  // The admittances of p, multiplied by both normal components to avoid divisions; signs as stated above.
  const Real outside2 = film.outside_index * film.outside_index;
  const Complex film2 = film.film_index * film.film_index;
  const Complex base2 = film.base_index * film.base_index;
  return {sum(boundary_reflection(waves.outside, waves.film), boundary_reflection(waves.film, waves.base)),
          sum(boundary_reflection(film2 * waves.outside.real(), outside2 * waves.film),
              boundary_reflection(base2 * waves.film, film2 * waves.base))};
}

/// Reflectance for unpolarised light.
template <typename Real>
Real film_reflectance(const ThinFilm<Real>& film, Real cos_i, Real wavelength_nm) {
  const FresnelAmplitudes<Real> r = film_reflection(film, cos_i, wavelength_nm);
  return (std::norm(r.s) + std::norm(r.p)) / 2;
}

template <typename Real>
AlignedMueller<Real> film_mueller(const ThinFilm<Real>& film, Real cos_i, Real wavelength_nm) {
  const FresnelAmplitudes<Real> r = film_reflection(film, cos_i, wavelength_nm);
  return aligned_mueller(r.s, r.p);
}

/// Transmission into a base that does not absorb. The amplitudes are scaled so that |s|^2 and |p|^2 are
/// transmittances for power, 0 if no wave propagates in the base. The scaling of radiance by the squared
/// ratio of the indices is left to the renderer.
template <typename Real>
FresnelAmplitudes<Real> film_transmission(const ThinFilm<Real>& film, Real cos_i, Real wavelength_nm) {
  using Complex = std::complex<Real>;
  const FilmWaves<Real> waves = film_waves(film, cos_i, wavelength_nm);
  const Complex twice = waves.through * waves.through;
  // With admittances y, the tangential field beyond a boundary is 2 y_near / (y_near + y_far) times the
  // incident field, and the power of a wave is y times its square.
  const auto sum = [&](Complex outside, Complex inside, Complex base) {
    const Complex top = boundary_reflection(outside, inside);
    const Complex bottom = boundary_reflection(inside, base);
    const Complex passed =
        (Real(1) + top) * (Real(1) + bottom) * waves.through / (Real(1) + top * bottom * twice);
    return passed * std::sqrt(base.real() / outside.real());
  };
  const Complex outside_p = film.outside_index * film.outside_index / waves.outside;
  const Complex film_p = film.film_index * film.film_index / waves.film;
  const Complex base_p = film.base_index * film.base_index / waves.base;
  return {sum(waves.outside, waves.film, waves.base), sum(outside_p, film_p, base_p)};
}

}  // namespace snippets

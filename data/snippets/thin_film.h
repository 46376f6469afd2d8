#pragma once

// Iridescence: a thin film on a metal or a dielectric, with all reflections inside the film and their phases
// (the Airy sum), for each polarisation. Free to copy into any renderer: C++20, the standard library only.
//
//   outside (real index, usually 1) | film (real or absorbing) | base (real or absorbing)
//
// Indices are n + i k with k > 0 where the medium absorbs (fields vary as exp(-i w t)). The plane of
// incidence gives the two polarisations: s across it, p in it, with the signs of fresnel_mueller.h (r_p =
// -r_s at normal incidence), so that aligned_mueller(r.s, r.p) of that file is the Mueller matrix of the
// reflection. The amplitudes hold for one wavelength; who renders in RGB must integrate the reflectance over
// the spectrum first: three wavelengths alias.
//
// Born and Wolf, "Principles of Optics", 7th edition, 1.6.4 (eq. 57 to 60) and 14.4.

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

/// Amplitudes of the two polarisations over that of the incident wave.
template <typename Real>
struct FilmAmplitudes {
  std::complex<Real> s;
  std::complex<Real> p;
};

/// Two media as one polarisation meets them: their admittances, up to a common factor. For s that is the
/// normal component of the wave vector, for p the squared index over it.
template <typename Real>
std::complex<Real> film_boundary_reflection(std::complex<Real> near, std::complex<Real> far) {
  return (near - far) / (near + far);
}

/// Normal components of the wave vector (over 2 pi / wavelength in vacuum) in the three media, and the phase
/// of one way through the film.
template <typename Real>
struct FilmWaves {
  std::complex<Real> outside;
  std::complex<Real> film;
  std::complex<Real> base;
  std::complex<Real> through;  // exp(i k_z height)
};

/// cos_i in (0, 1], in the outer medium. Every root is the one of a wave that fades where it cannot travel.
template <typename Real>
FilmWaves<Real> film_waves(const ThinFilm<Real>& film, Real cos_i, Real wavelength_nm) {
  const Real n2 = film.outside_index * film.outside_index;
  const Real across2 =
      n2 * (1 - cos_i) * (1 + cos_i);  // squared component along the surface, the same everywhere
  FilmWaves<Real> waves;
  waves.outside = film.outside_index * cos_i;
  waves.film = std::sqrt(film.film_index * film.film_index - across2);
  waves.base = std::sqrt(film.base_index * film.base_index - across2);
  const Real turn = 2 * std::numbers::pi_v<Real> * film.height_nm / wavelength_nm;
  waves.through = std::exp(std::complex<Real>(0, turn) * waves.film);
  return waves;
}

/// Reflected field over incident field. |s|^2 and |p|^2 are the reflectances. NaN (0 / 0) at the one angle
/// where a wave runs exactly along a film whose index is below that of the outer medium.
template <typename Real>
FilmAmplitudes<Real> film_reflection(const ThinFilm<Real>& film, Real cos_i, Real wavelength_nm) {
  using Complex = std::complex<Real>;
  const FilmWaves<Real> waves = film_waves(film, cos_i, wavelength_nm);
  const Complex twice = waves.through * waves.through;
  const auto sum = [&](Complex top, Complex bottom) {
    return (top + bottom * twice) / (Real(1) + top * bottom * twice);
  };
  const Complex outside_p = film.outside_index * film.outside_index / waves.outside;
  const Complex film_p = film.film_index * film.film_index / waves.film;
  const Complex base_p = film.base_index * film.base_index / waves.base;
  return {sum(film_boundary_reflection(waves.outside, waves.film),
              film_boundary_reflection(waves.film, waves.base)),
          sum(film_boundary_reflection(film_p, outside_p), film_boundary_reflection(base_p, film_p))};
}

/// What becomes of unpolarised light.
template <typename Real>
Real film_reflectance(const ThinFilm<Real>& film, Real cos_i, Real wavelength_nm) {
  const FilmAmplitudes<Real> r = film_reflection(film, cos_i, wavelength_nm);
  return (std::norm(r.s) + std::norm(r.p)) / 2;
}

/// Into a base that does not absorb: amplitudes scaled such that |s|^2 and |p|^2 are the transmitted shares
/// of the power, 0 where no wave travels on in the base. Radiance changes by the squared ratio of indices on
/// top of it, which is the renderer's to apply or not.
template <typename Real>
FilmAmplitudes<Real> film_transmission(const ThinFilm<Real>& film, Real cos_i, Real wavelength_nm) {
  using Complex = std::complex<Real>;
  const FilmWaves<Real> waves = film_waves(film, cos_i, wavelength_nm);
  const Complex twice = waves.through * waves.through;
  // With admittances y the tangential field behind a boundary is 2 y_near / (y_near + y_far) of that before
  // it, and the power that a wave carries is y times its square.
  const auto sum = [&](Complex outside, Complex inside, Complex base) {
    const Complex top = film_boundary_reflection(outside, inside);
    const Complex bottom = film_boundary_reflection(inside, base);
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

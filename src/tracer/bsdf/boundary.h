#pragma once

#include "scene/spectral.h"
#include "snippets/thin_film.h"
#include "tracer/bsdf/fresnel.h"

#include <array>
#include <complex>
#include <cstddef>
#include <optional>

/// The boundary between two media, seen from the side of the viewer.
namespace orbs::tracer {

/// Its indices at N wavelengths of one path.
template <std::size_t N>
struct Boundary {
  std::array<std::complex<float>, N> index{};  // beyond the surface over the viewer's side
  std::array<float, N> film_index{};           // over the viewer's side
  float film_height_nm = 0;                    // 0: no film
  std::array<float, N> nm{};                   // wavelengths in the viewer's medium; unused without a film
};

/// `beyond` is a spectra::RefractiveIndex for dielectrics and a spectra::MetalIndex for conductors; `nm` are
/// vacuum wavelengths.
template <std::size_t N>
Boundary<N> boundary_between(const std::array<float, N>& nm,
                             const spectra::RefractiveIndex& this_side,
                             const auto& beyond,
                             const std::optional<scene::Film>& film) {
  Boundary<N> out;
  if (film) out.film_height_nm = static_cast<float>(film->height_nm);
  for (std::size_t i = 0; i < N; ++i) {
    const auto at = static_cast<double>(nm[i]);
    const double here = index_at(this_side, at);
    const std::complex<double> index = index_at(beyond, at) / here;
    out.index[i] = {static_cast<float>(index.real()), static_cast<float>(index.imag())};
    if (!film) continue;
    out.film_index[i] = static_cast<float>(index_at(film->index, at) / here);
    out.nm[i] = static_cast<float>(at / here);
  }
  return out;
}

template <std::size_t N>
bool has_film(const Boundary<N>& at) {
  return at.film_height_nm > 0;
}

template <std::size_t N>
snippets::ThinFilm<float> film_at(const Boundary<N>& at, std::size_t i) {
  return {1, std::complex<float>(at.film_index[i]), at.index[i], at.film_height_nm};
}

/// Reflectance for unpolarised light; cos_i in (0, 1].
template <std::size_t N>
std::array<float, N> reflectances(const Boundary<N>& at, float cos_i) {
  std::array<float, N> out{};
  for (std::size_t i = 0; i < N; ++i) {
    if (has_film(at))
      out[i] = snippets::film_reflectance(film_at(at, i), cos_i, at.nm[i]);
    else if (at.index[i].imag() == 0)
      out[i] = fresnel_dielectric(cos_i, at.index[i].real());
    else
      out[i] = snippets::reflection_mueller(cos_i, at.index[i]).mean;
  }
  return out;
}

/// Mueller matrix of reflection at wavelength i.
template <std::size_t N>
snippets::AlignedMueller<float> reflection(const Boundary<N>& at, std::size_t i, float cos_i) {
  if (has_film(at)) return snippets::film_mueller(film_at(at, i), cos_i, at.nm[i]);
  return snippets::reflection_mueller(cos_i, at.index[i]);
}

/// Mueller matrix of transmission at wavelength i, for powers; neither medium may absorb.
template <std::size_t N>
snippets::AlignedMueller<float> transmission(const Boundary<N>& at, std::size_t i, float cos_i) {
  if (!has_film(at)) return snippets::transmission_mueller(cos_i, at.index[i].real());
  const auto passed = snippets::film_transmission(film_at(at, i), cos_i, at.nm[i]);
  return snippets::aligned_mueller(passed.s, passed.p);
}

template <std::size_t N>
float mean_of(const std::array<float, N>& values) {
  float sum = 0;
  for (const float value : values) sum += value;
  return sum / static_cast<float>(N);
}

template <std::size_t N>
std::array<float, N> one_minus(const std::array<float, N>& values) {
  std::array<float, N> out{};
  for (std::size_t i = 0; i < N; ++i) out[i] = 1 - values[i];
  return out;
}

}  // namespace orbs::tracer

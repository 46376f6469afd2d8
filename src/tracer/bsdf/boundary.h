#pragma once

#include "snippets/thin_film.h"
#include "tracer/bsdf/fresnel.h"

#include <array>
#include <complex>
#include <cstddef>

/// The boundary between two media, as the paths see it that meet it from one side.
namespace orbs::tracer {

/// At N wavelengths of one path.
template <std::size_t N>
struct Boundary {
  std::array<std::complex<float>, N> index{};  // beyond the surface over this side's
  std::array<float, N> film_index{};           // over this side's
  float film_height_nm = 0;                    // 0: no film
  std::array<float, N> nm{};                   // wavelengths within this side's medium; unused without a film
};

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

/// What the reflection does to polarised light, at wavelength i.
template <std::size_t N>
snippets::AlignedMueller<float> reflection(const Boundary<N>& at, std::size_t i, float cos_i) {
  if (has_film(at)) return snippets::film_mueller(film_at(at, i), cos_i, at.nm[i]);
  return snippets::reflection_mueller(cos_i, at.index[i]);
}

/// What passing through does to the power of polarised light; between media that do not absorb.
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

/// 1 - each.
template <std::size_t N>
std::array<float, N> one_minus(const std::array<float, N>& values) {
  std::array<float, N> out{};
  for (std::size_t i = 0; i < N; ++i) out[i] = 1 - values[i];
  return out;
}

}  // namespace orbs::tracer

#pragma once

#include "tracer/bsdf_at.h"
#include "tracer/reradiation.h"
#include "tracer/scatter/interface_bsdf.h"

/// Surfaces beyond ORB.S at the wavelengths of a path.
namespace orbs::tracer {

/// The wavelengths of a path; for colour, whose indices are the same at all of them, any.
template <Transport T>
std::array<float, T::kWavelengths> wavelengths_of(const typename T::Lambda& lambda) {
  if constexpr (requires { lambda.nm; })
    return lambda.nm;
  else
    return {550};  // or, where the colour paths were asked for all the same, some in the middle
}

/// `beyond` is real for dielectrics, complex for metals.
template <std::size_t N>
Interface<N> interface_between(const std::array<float, N>& nm,
                               const spectra::RefractiveIndex& this_side,
                               const auto& beyond,
                               const std::optional<scene::Film>& film) {
  Interface<N> out;
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

template <Transport T>
void place_conductor(typename T::Bsdf& out,
                     const scene::Conductor& metal,
                     bool is_outside,
                     const typename T::Lambda& lambda) {
  using Value = typename T::Value;
  constexpr auto kN = T::kWavelengths;
  if (!is_outside) {
    out = LambertBsdf<Value>{};  // black from behind
    return;
  }
  const auto interface =
      interface_between<kN>(wavelengths_of<T>(lambda), metal.outside, metal.index, metal.film);
  if (metal.roughness)
    out = RoughConductorBsdf<Value, kN>{interface, microfacets(*metal.roughness)};
  else
    out = ConductorBsdf<Value, kN>{interface};
}

template <Transport T>
void place_dielectric(typename T::Bsdf& out,
                      const DielectricSurface& surface,
                      bool is_outside,
                      const Visit<T>& visit) {
  using Value = typename T::Value;
  constexpr auto kN = T::kWavelengths;
  if constexpr (requires { T::drop_companions(visit.lambda, visit.weight); })
    if (surface.is_dispersive) T::drop_companions(visit.lambda, visit.weight);
  const scene::Dielectric& glass = surface.model;
  const auto& here = is_outside ? glass.outside : glass.index;
  const auto& beyond = is_outside ? glass.index : glass.outside;
  const auto interface = interface_between<kN>(wavelengths_of<T>(visit.lambda), here, beyond, glass.film);
  if (glass.roughness)
    out = RoughDielectricBsdf<Value, kN>{interface, microfacets(*glass.roughness)};
  else
    out = DielectricBsdf<Value, kN>{interface};
}

template <Transport T>
void place_interface_bsdf(typename T::Bsdf& out,
                          const World& world,
                          const SurfaceMaterial& material,
                          bool is_outside,
                          const Visit<T>& visit) {
  using Value = typename T::Value;
  const auto details = static_cast<std::size_t>(material.details);
  switch (material.model) {
    case Model::Conductor:
      return place_conductor<T>(out, world.conductors[details], is_outside, visit.lambda);
    case Model::Dielectric:
      return place_dielectric<T>(out, world.dielectrics[details], is_outside, visit);
    case Model::Sheet:
      out = SheetBsdf<Value, T::kWavelengths>{world.sheets[details].element, world.sheets[details].axis};
      return;
    case Model::Fluorescent:
      if constexpr (requires { requires T::kFluoresces; }) {
        out = LambertBsdf<Value>{reradiate<T>(world, material.colour, world.reradiations[details], visit)};
      } else {
        // Its kernel is zero, or fluorescence is to be left out.
        out = LambertBsdf<Value>{T::reflectance(world, material.colour, visit.lambda)};
      }
      return;
    default:
      break;
  }
  assert(false && "not a model beyond ORB.S");
}

}  // namespace orbs::tracer

#pragma once

#include "tracer/integrator/make_bsdf.h"
#include "tracer/bsdf/reradiation.h"
#include "tracer/bsdf/boundary_bsdf.h"

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

template <Transport T>
void make_conductor(typename T::Bsdf& out,
                     const scene::Conductor& metal,
                     bool is_outside,
                     const typename T::Lambda& lambda) {
  using Value = typename T::Value;
  constexpr auto kN = T::kWavelengths;
  if (!is_outside) {
    out = LambertBsdf<Value>{};  // black from behind
    return;
  }
  const auto boundary =
      boundary_between<kN>(wavelengths_of<T>(lambda), metal.outside, metal.index, metal.film);
  if (metal.roughness)
    out = RoughConductorBsdf<Value, kN>{boundary, microfacets(*metal.roughness)};
  else
    out = ConductorBsdf<Value, kN>{boundary};
}

template <Transport T>
void make_dielectric(typename T::Bsdf& out,
                      const DielectricSurface& surface,
                      bool is_outside,
                      const ShadingContext<T>& context) {
  using Value = typename T::Value;
  constexpr auto kN = T::kWavelengths;
  if constexpr (requires { T::terminate_secondary(context.lambda, context.throughput); })
    if (surface.is_dispersive) T::terminate_secondary(context.lambda, context.throughput);
  const scene::Dielectric& glass = surface.model;
  const auto& here = is_outside ? glass.outside : glass.index;
  const auto& beyond = is_outside ? glass.index : glass.outside;
  const auto boundary = boundary_between<kN>(wavelengths_of<T>(context.lambda), here, beyond, glass.film);
  if (glass.roughness)
    out = RoughDielectricBsdf<Value, kN>{boundary, microfacets(*glass.roughness)};
  else
    out = DielectricBsdf<Value, kN>{boundary};
}

template <Transport T>
void make_appearance_bsdf(typename T::Bsdf& out,
                          const World& world,
                          const SurfaceMaterial& material,
                          bool is_outside,
                          const ShadingContext<T>& context) {
  using Value = typename T::Value;
  const auto details = static_cast<std::size_t>(material.details);
  switch (material.model) {
    case Model::Conductor:
      return make_conductor<T>(out, world.conductors[details], is_outside, context.lambda);
    case Model::Dielectric:
      return make_dielectric<T>(out, world.dielectrics[details], is_outside, context);
    case Model::ThinElement:
      out = ThinElementBsdf<Value, T::kWavelengths>{world.thin_elements[details].element, world.thin_elements[details].axis};
      return;
    case Model::Fluorescent:
      if constexpr (requires { requires T::kFluoresces; }) {
        out = LambertBsdf<Value>{reradiate<T>(world, material.colour, world.reradiations[details], context)};
      } else {
        // Its kernel is zero, or fluorescence is to be left out.
        out = LambertBsdf<Value>{T::reflectance(world, material.colour, context.lambda)};
      }
      return;
    default:
      break;
  }
  assert(false && "not a model beyond ORB.S");
}

}  // namespace orbs::tracer

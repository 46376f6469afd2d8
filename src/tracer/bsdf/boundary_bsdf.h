#pragma once

#include "tracer/bsdf/boundary.h"
#include "tracer/bsdf/bsdf_sample.h"
#include "tracer/bsdf/microfacets.h"
#include "tracer/bsdf/polarisation.h"

#include <cstddef>
#include <optional>

/// What the BSDFs of conductors and dielectrics share: a boundary between two media, smooth or made of
/// microfacets. Each derives from one of these and adds how it samples directions.
namespace orbs::tracer {

template <typename Value, std::size_t N>
struct SmoothBoundaryBsdf {
  static constexpr bool kIsDelta = true;
  static constexpr bool kDepolarises = false;
  static constexpr Event kEvent = Event::Specular;
  Boundary<N> boundary;
};

/// A delta function has no value at any pair of directions that was not sampled from it.
template <typename Value, std::size_t N>
BsdfValue<Value> evaluate(const SmoothBoundaryBsdf<Value, N>&, Vec3f, Vec3f) {
  return {};
}

template <typename Value, std::size_t N>
std::optional<Polarisation> polarisation_by(const SmoothBoundaryBsdf<Value, N>& bsdf,
                                            const auto& scattering) {
  return facet_polarisation(bsdf.boundary, kUp, scattering);
}

template <typename Value, std::size_t N>
struct RoughBoundaryBsdf {
  static constexpr bool kIsDelta = false;
  static constexpr bool kDepolarises = false;
  static constexpr Event kEvent = Event::Glossy;
  Boundary<N> boundary;
  Microfacets facets;
};

}  // namespace orbs::tracer

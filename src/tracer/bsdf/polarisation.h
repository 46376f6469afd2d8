#pragma once

#include "snippets/fresnel_mueller.h"
#include "tracer/bsdf/boundary.h"
#include "tracer/bsdf/broadcast.h"
#include "tracer/bsdf/bsdf_sample.h"
#include "tracer/bsdf/fresnel.h"

#include <optional>
#include <type_traits>
#include <variant>

/// How BSDFs polarise the light that they scatter. A BSDF says kDepolarises, or its file has
/// polarisation_by(bsdf, scattering); conventions as in data/snippets/fresnel_mueller.h.
namespace orbs::tracer {

/// A Mueller matrix divided by its first element, which the scattering factor contains already: entries of
/// snippets::AlignedMueller with `mean` = 1, at four wavelengths.
struct ElementShape {
  Float4 half{};
  Float4 real{};
  Float4 imaginary{};
};

struct Polarisation {
  ElementShape element;
  Vec3f x_leaving;   // x axis of the element across the light that leaves towards the viewer, in the world
  Vec3f x_arriving;  // the same across the arriving light
};

inline void set_shape(ElementShape& out, std::size_t i, const snippets::AlignedMueller<float>& element) {
  if (element.mean == 0) return;  // no light leaves, hence none that is polarised
  out.half[i] = element.half / element.mean;
  out.real[i] = element.real / element.mean;
  out.imaginary[i] = element.imaginary / element.mean;
}

/// Unit vector across the plane of incidence at a microfacet m: the x axis of s-polarised light. At normal
/// incidence every direction across the ray will do, as |r_s| = |r_p| there.
inline Vec3f across_incidence(Vec3f wo, Vec3f m) {
  const Vec3f across = cross(wo, m);
  const float squared = dot(across, across);
  return squared > 0 ? across / std::sqrt(squared) : frame_around(m).x;
}

template <std::size_t N>
ElementShape shape_of(const Boundary<N>& at, float cos_o, bool is_transmitted) {
  ElementShape out;
  for (std::size_t i = 0; i < N; ++i)
    set_shape(out, i, is_transmitted ? transmission(at, i, cos_o) : reflection(at, i, cos_o));
  return out;
}

/// Polarisation by reflection or transmission at a microfacet m.
template <std::size_t N>
Polarisation facet_polarisation(const Boundary<N>& at, Vec3f m, const auto& scattering) {
  const Vec3f x = scattering.frame.to_world(across_incidence(scattering.wo, m));
  return {shape_of(at, dot(scattering.wo, m), scattering.wi.z < 0), x, x};
}

/// The same at the microfacet that takes wo to wi; nothing if there is none.
template <std::size_t N>
std::optional<Polarisation> facet_polarisation_between(const Boundary<N>& at, const auto& scattering) {
  const auto m = facet_between(scattering.wo, scattering.wi, at.index[0].real());
  if (!m) return std::nullopt;
  return facet_polarisation(at, *m, scattering);
}

/// Normal of a smooth surface in the local frame.
constexpr Vec3f kUp{0, 0, 1};

/// The boundary of ORB.S's glass, whose index is the same at all wavelengths.
inline Boundary<4> boundary_of(float eta) {
  Boundary<4> at;
  at.index.fill(eta);
  return at;
}

/// Nothing if the BSDF depolarises.
template <typename Bsdf>
std::optional<Polarisation> polarisation_of(const Scattering<Bsdf>& scattering) {
  return std::visit(
      [&](const auto& bsdf) -> std::optional<Polarisation> {
        if constexpr (std::decay_t<decltype(bsdf)>::kDepolarises)
          return std::nullopt;
        else
          return polarisation_by(bsdf, scattering);
      },
      scattering.bsdf);
}

}  // namespace orbs::tracer

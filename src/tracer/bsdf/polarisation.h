#pragma once

#include "tracer/bsdf/boundary_bsdf.h"
#include "tracer/bsdf/scattering.h"

#include <optional>

/// How the surfaces polarise the light that they scatter.
namespace orbs::tracer {

/// A Mueller matrix over its first entry, which the factor of the scattering has already: entries of
/// snippets::AlignedMueller at four wavelengths, `mean` being 1.
struct ElementShape {
  Float4 half{};
  Float4 real{};
  Float4 imaginary{};
};

struct Polarisation {
  ElementShape element;
  Vec3f x_leaving;   // the element's x across the light that leaves towards the viewer, in the world
  Vec3f x_arriving;  // and across the light that arrives
};

inline void set_shape(ElementShape& out, std::size_t i, const snippets::AlignedMueller<float>& element) {
  if (element.mean == 0) return;  // no light, hence none that is polarised
  out.half[i] = element.half / element.mean;
  out.real[i] = element.real / element.mean;
  out.imaginary[i] = element.imaginary / element.mean;
}

/// Across the plane of incidence at a facet m: what s-polarised light has for x. At normal incidence any
/// direction across will do, the two amplitudes being equal but for the sign that stands for the mirror.
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

/// Nothing for surfaces that forget polarisation: those that scatter light more than once within.
template <typename B>
std::optional<Polarisation> polarisation_by(const B&, const auto&) {
  return std::nullopt;
}

/// Of light that a facet m has reflected or transmitted.
template <std::size_t N>
Polarisation facet_polarisation(const Boundary<N>& at, Vec3f m, const auto& where) {
  const Vec3f x = where.frame.to_world(across_incidence(where.wo, m));
  return {shape_of(at, dot(where.wo, m), where.wi.z < 0), x, x};
}

template <std::size_t N>
std::optional<Polarisation> facet_polarisation_between(const Boundary<N>& at, const auto& where) {
  const auto m = facet_between(where.wo, where.wi, at.index[0].real());
  if (!m) return std::nullopt;
  return facet_polarisation(at, *m, where);
}

constexpr Vec3f kUp{0, 0, 1};

template <typename V, std::size_t N>
std::optional<Polarisation> polarisation_by(const ConductorBsdf<V, N>& b, const auto& where) {
  return facet_polarisation(b.boundary, kUp, where);
}
template <typename V, std::size_t N>
std::optional<Polarisation> polarisation_by(const RoughConductorBsdf<V, N>& b, const auto& where) {
  return facet_polarisation(b.boundary, normalised(where.wo + where.wi), where);
}
template <typename V, std::size_t N>
std::optional<Polarisation> polarisation_by(const DielectricBsdf<V, N>& b, const auto& where) {
  return facet_polarisation(b.boundary, kUp, where);
}
template <typename V, std::size_t N>
std::optional<Polarisation> polarisation_by(const RoughDielectricBsdf<V, N>& b, const auto& where) {
  return facet_polarisation_between(b.boundary, where);
}
template <typename V, std::size_t N>
std::optional<Polarisation> polarisation_by(const ThinElementBsdf<V, N>& b, const auto& where) {
  Polarisation out;
  for (std::size_t i = 0; i < N; ++i) set_shape(out.element, i, b.element);
  const Vec3f within = b.axis - where.frame.z * dot(where.frame.z, b.axis);
  out.x_leaving = normalised(within - where.to_viewer * dot(where.to_viewer, within));
  out.x_arriving = out.x_leaving;  // the light goes straight on
  return out;
}

inline Boundary<4> boundary_of(float eta) {
  Boundary<4> at;
  at.index.fill(eta);
  return at;
}
template <typename V>
std::optional<Polarisation> polarisation_by(const GlassBsdf<V>& b, const auto& where) {
  return facet_polarisation(boundary_of(b.eta), kUp, where);
}
template <typename V>
std::optional<Polarisation> polarisation_by(const RoughGlassBsdf<V>& b, const auto& where) {
  return facet_polarisation_between(boundary_of(b.eta), where);
}
/// ORB.S's perfect mirror has no index; it turns the field over as a perfect conductor does.
template <typename V>
std::optional<Polarisation> polarisation_by(const MirrorBsdf<V>&, const auto& where) {
  constexpr snippets::AlignedMueller<float> kTurnedOver{1, 0, -1, 0};
  const Vec3f x = where.frame.to_world(across_incidence(where.wo, kUp));
  Polarisation out{{}, x, x};
  for (std::size_t i = 0; i < 4; ++i) set_shape(out.element, i, kTurnedOver);
  return out;
}

template <typename Bsdf>
std::optional<Polarisation> polarisation_of(const Scattering<Bsdf>& where) {
  return std::visit([&](const auto& b) { return polarisation_by(b, where); }, where.bsdf);
}

}  // namespace orbs::tracer

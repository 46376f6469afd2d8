#pragma once

#include "base/nth.h"
#include "tracer/sampling/sampler.h"
#include "tracer/transport/transport.h"
#include "tracer/world/surface.h"

#include <cassert>
#include <type_traits>

namespace orbs::tracer {

/// A path at a hit point, as the make_bsdf functions of the materials see it. They may change the path's
/// lambda and throughput: dispersion ends its secondary wavelengths, fluorescence moves all of them.
template <Transport T>
struct ShadingContext {
  using Value = typename T::Value;
  using Bsdf = typename T::Bsdf;
  static constexpr std::size_t kWavelengths = T::kWavelengths;
  static constexpr bool kFluoresces = T::kFluoresces;

  const World& world;
  const SurfaceHit& surface;
  bool is_outside = true;  // the viewer is on the side to which the vertex normals point
  typename T::Lambda& lambda;
  typename T::Throughput& throughput;
  SampleBlock block;  // of the path's random numbers
  std::uint32_t index = 0;
  std::uint32_t bounce = 0;

  Value reflectance(const Colour& colour) const { return T::reflectance(world, colour, lambda); }

  /// The colour times the texture, if there is one: three channels.
  Vec3f textured(const TexturedColour& textured) const {
    if (textured.texture < 0) return textured.colour.rgb;
    return textured.colour.rgb *
           lookup(nth(world.textures, textured.texture), texture_coordinates(world, surface, textured.uv));
  }

  Value reflectance(const TexturedColour& of) const {
    Colour colour = of.colour;
    if (of.texture >= 0) colour.rgb = textured(of);
    return reflectance(colour);
  }

  /// See tracer::direction_of_u.
  Vec3f direction_of_u() const { return tracer::direction_of_u(world, surface); }

  /// Vacuum wavelengths.
  std::array<float, kWavelengths> wavelengths_nm() const { return T::wavelengths_nm(lambda); }
  void set_wavelengths_nm(const std::array<float, kWavelengths>& nm) const {
    T::set_wavelengths_nm(lambda, nm);
  }
  void terminate_secondary() const { T::terminate_secondary(lambda, throughput); }

  std::array<float, 4> draw(SampleDimension dimension) const {
    return tracer::draw(block, index, bounce, dimension);
  }
};

/// The BSDF of the material at the hit point. Out-parameter: returning the variant stalls store forwarding
/// (25 ns per call, measured).
template <Transport T>
void make_bsdf(typename T::Bsdf& out, const ShadingContext<T>& at) {
  std::visit(
      [&](const auto& material) {
        if constexpr (T::kHasAppearance || !std::decay_t<decltype(material)>::kIsAppearance)
          make_bsdf(out, material, at);
        else
          assert(false && "World::has_appearance_materials selects a kernel that has them");
      },
      at.surface.material.model);
}

}  // namespace orbs::tracer

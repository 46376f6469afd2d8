#pragma once

#include "tracer/sampler.h"
#include "tracer/scatter/bsdf.h"
#include "tracer/surface.h"
#include "tracer/transport.h"

#include <cassert>

namespace orbs::tracer {

/// A path at a surface, which may change its wavelengths.
template <Transport T>
struct Visit {
  typename T::Lambda& lambda;
  typename T::Weight& weight;
  SampleBlock block;  // its random numbers
  std::uint32_t index = 0;
  std::uint32_t bounce = 0;
};

inline bool is_of_orbs(Model model) { return model < Model::Conductor; }

/// The models of ORB.S, seen from outside (where the vertex normal points) or inside. Built where it is
/// needed: as a return value it would be copied in pieces that the processor cannot forward, 25 ns each.
template <Transport T>
void place_orbs_bsdf(typename T::Bsdf& out,
                     const World& world,
                     const MetSurface& met,
                     bool is_outside,
                     const typename T::Lambda& lambda) {
  using Value = typename T::Value;
  const SurfaceMaterial& material = met.material;
  Colour surface = material.colour;
  if (material.texture >= 0)
    surface.rgb *= lookup(world.textures[static_cast<std::size_t>(material.texture)],
                          apply(material.uv, texture_coordinates(world, met)));
  const Value colour = T::reflectance(world, surface, lambda);
  const float eta = is_outside ? material.ior : 1 / material.ior;
  switch (material.model) {
    case Model::Lambert:
      out = LambertBsdf<Value>{colour};
      return;
    case Model::OrenNayar:
      out = make_oren_nayar(colour, material.roughness);
      return;
    case Model::Mirror:
      out = MirrorBsdf<Value>{colour};
      return;
    case Model::Glass:
      out = GlassBsdf<Value>{colour, eta};
      return;
    case Model::Ggx:
      out = GgxBsdf<Value>{colour, material.alpha};
      return;
    case Model::RoughGlass:
      out = RoughGlassBsdf<Value>{colour, eta, material.alpha};
      return;
    default:
      break;
  }
  assert(false && "emissive surfaces end the path before they scatter");
}

/// The models beyond ORB.S (place_interface.h).
template <Transport T>
void place_interface_bsdf(typename T::Bsdf& out,
                          const World& world,
                          const SurfaceMaterial& material,
                          bool is_outside,
                          const Visit<T>& visit);

/// The scattering function of a material at a point. Dispersion and fluorescence change the path first.
template <Transport T>
void place_bsdf(typename T::Bsdf& out,
                const World& world,
                const MetSurface& met,
                bool is_outside,
                const Visit<T>& visit) {
  if constexpr (requires { T::kWavelengths; })
    if (!is_of_orbs(met.material.model)) {
      place_interface_bsdf<T>(out, world, met.material, is_outside, visit);
      return;
    }
  place_orbs_bsdf<T>(out, world, met, is_outside, visit.lambda);
}

}  // namespace orbs::tracer

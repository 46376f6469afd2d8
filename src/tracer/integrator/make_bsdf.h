#pragma once

#include "tracer/sampling/sampler.h"
#include "tracer/bsdf/bsdf.h"
#include "tracer/world/surface.h"
#include "tracer/transport/transport.h"

#include <cassert>

namespace orbs::tracer {

/// A path at a surface, which may change its wavelengths.
template <Transport T>
struct ShadingContext {
  typename T::Lambda& lambda;
  typename T::Throughput& weight;
  SampleBlock block;  // its random numbers
  std::uint32_t index = 0;
  std::uint32_t bounce = 0;
};

inline bool is_of_orbs(Model model) { return model < Model::Conductor; }

/// The models of ORB.S, seen from outside (where the vertex normal points) or inside. Built where it is
/// needed: as a return value it would be copied in pieces that the processor cannot forward, 25 ns each.
template <Transport T>
void make_orbs_bsdf(typename T::Bsdf& out,
                     const World& world,
                     const SurfaceHit& surface,
                     bool is_outside,
                     const typename T::Lambda& lambda) {
  using Value = typename T::Value;
  const SurfaceMaterial& material = surface.material;
  Colour colour_here = material.colour;
  if (material.texture >= 0)
    colour_here.rgb *= lookup(world.textures[static_cast<std::size_t>(material.texture)],
                          apply(material.uv, texture_coordinates(world, surface)));
  const Value colour = T::reflectance(world, colour_here, lambda);
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
void make_appearance_bsdf(typename T::Bsdf& out,
                          const World& world,
                          const SurfaceMaterial& material,
                          bool is_outside,
                          const ShadingContext<T>& context);

/// The scattering function of a material at a point. Dispersion and fluorescence change the path first.
template <Transport T>
void make_bsdf(typename T::Bsdf& out,
                const World& world,
                const SurfaceHit& surface,
                bool is_outside,
                const ShadingContext<T>& context) {
  if constexpr (requires { T::kWavelengths; })
    if (!is_of_orbs(surface.material.model)) {
      make_appearance_bsdf<T>(out, world, surface.material, is_outside, context);
      return;
    }
  make_orbs_bsdf<T>(out, world, surface, is_outside, context.lambda);
}

}  // namespace orbs::tracer

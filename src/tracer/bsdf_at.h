#pragma once

#include "tracer/surface.h"
#include "tracer/transport.h"

#include <cassert>

namespace orbs::tracer {

/// The scattering function of a material at a point, seen from outside (where the vertex normal points) or
/// inside. Built where it is needed: as a return value it would be copied in pieces that the processor cannot
/// forward, 25 ns each.
template <Transport T>
void place_bsdf(Bsdf<typename T::Value>& out,
                const World& world,
                const SurfaceMaterial& material,
                const Hit& hit,
                bool is_outside,
                const typename T::Lambda& lambda) {
  using Value = typename T::Value;
  Vec3f rgb = material.colour;
  if (material.texture >= 0)
    rgb *= lookup(world.textures[static_cast<std::size_t>(material.texture)],
                  apply(material.uv, texture_coordinates(world, hit)));
  const Value colour = T::from_rgb(rgb, lambda);
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
    case Model::Emission:
      break;
  }
  assert(false && "emissive surfaces end the path before they scatter");
}

template <Transport T>
Bsdf<typename T::Value> bsdf_at(const World& world,
                                const SurfaceMaterial& material,
                                const Hit& hit,
                                bool is_outside,
                                const typename T::Lambda& lambda) {
  Bsdf<typename T::Value> out;
  place_bsdf<T>(out, world, material, hit, is_outside, lambda);
  return out;
}

}  // namespace orbs::tracer

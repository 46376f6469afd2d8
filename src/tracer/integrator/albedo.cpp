#include "tracer/integrator/albedo.h"

#include "base/nth.h"

#include <variant>

namespace orbs::tracer {

namespace {

struct Albedo {
  const World& world;
  const SurfaceHit& surface;

  Vec3f of(const Colour& colour) const { return colour.rgb; }
  Vec3f of(const TexturedColour& textured) const {
    if (textured.texture < 0) return textured.colour.rgb;
    return textured.colour.rgb *
           lookup(nth(world.textures, textured.texture), texture_coordinates(world, surface, textured.uv));
  }

  template <typename Material>
  Vec3f operator()(const Material& m) const {
    if constexpr (requires { m.reflectance; }) return of(m.reflectance);
    return {};
  }
  Vec3f operator()(const GgxMaterial& m) const { return of(m.colour); }
  Vec3f operator()(const AnisotropicGgxMaterial& m) const { return of(m.colour); }
  Vec3f operator()(const VaryingGgxMaterial& m) const { return of(m.colour); }
  Vec3f operator()(const MetallicRoughnessMaterial& m) const { return of(m.base); }
  Vec3f operator()(const GgxLambertMaterial& m) const { return of(m.glossy) + of(m.diffuse); }
  Vec3f operator()(const BlendMaterial& m) const {
    const float weight = of(m.weight).x;
    const auto part = [&](std::size_t i) {
      return std::visit(
          [&](const auto& model) {
            if constexpr (std::is_same_v<std::decay_t<decltype(model)>, BlendMaterial>)
              return Vec3f{};
            else
              return (*this)(model);
          },
          nth(world.materials, m.parts.at(i)).model);
    };
    return part(0) * (1 - weight) + part(1) * weight;
  }
};

}  // namespace

Vec3f albedo_of(const World& world, const SurfaceHit& surface) {
  return std::visit(Albedo{world, surface}, surface.material.model);
}

}  // namespace orbs::tracer

#pragma once

#include "base/nth.h"
#include "tracer/bsdf/bsdf_sample.h"
#include "tracer/colour/scene_colours.h"
#include "tracer/sampling/sample_dimension.h"

#include <array>
#include <cassert>
#include <type_traits>
#include <variant>

namespace orbs::tracer {

/// Each path that meets a blend meets one of its parts, chosen at random by the weight: it has the BSDFs of
/// those.
struct BlendMaterial {
  static constexpr bool kIsAppearance = true;
  template <typename Value, std::size_t N>
  using Bsdfs = BsdfList<>;
  std::array<int, 2> parts{};  // indices into World::materials
  TexturedColour weight;
};

inline BlendMaterial make_material(const scene::Blend& m, const SceneColours& colours) {
  return {{m.parts[0].material, m.parts[1].material},
          make_textured_colour(colours, {m.weight, m.weight, m.weight}, {}, m.texture)};
}

/// Whatever its parts have: so no light path ends at it, where it would have to meet the same part as the
/// camera path that is connected to it.
inline float lobe_alpha(const BlendMaterial&) { return kPartlyDelta; }

template <typename Context>
void make_bsdf(typename Context::Bsdf& out, const BlendMaterial& material, const Context& at) {
  const bool is_second = at.draw(SampleDimension::Blend)[0] < at.textured(material.weight).x;
  std::visit(
      [&](const auto& part) {
        if constexpr (std::is_same_v<std::decay_t<decltype(part)>, BlendMaterial>)
          assert(false && "the parts of blends are no blends");
        else
          make_bsdf(out, part, at);
      },
      nth(at.world.materials, material.parts[is_second ? 1 : 0]).model);
}

}  // namespace orbs::tracer

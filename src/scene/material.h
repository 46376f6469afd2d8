#pragma once

#include "scene/materials/anisotropic_ggx.h"
#include "scene/materials/blend.h"
#include "scene/materials/conductor.h"
#include "scene/materials/dielectric.h"
#include "scene/materials/emission.h"
#include "scene/materials/fluorescent.h"
#include "scene/materials/ggx.h"
#include "scene/materials/ggx_lambert.h"
#include "scene/materials/glass.h"
#include "scene/materials/lambert.h"
#include "scene/materials/metal.h"
#include "scene/materials/metallic_roughness.h"
#include "scene/materials/mirror.h"
#include "scene/materials/oren_nayar.h"
#include "scene/materials/phong.h"
#include "scene/materials/plastic.h"
#include "scene/materials/polariser.h"
#include "scene/materials/retarder.h"
#include "scene/materials/rough_glass.h"
#include "scene/materials/varying_ggx.h"
#include "scene/surface_detail.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace orbs::scene {

/// Variants of types of materials only, see MaterialType.
template <MaterialType... Types>
using MaterialVariant = std::variant<Types...>;

/// All types, in the order in which messages list them: those of ORB.S, then those that go beyond it.
using MaterialModel = MaterialVariant<Lambert,
                                      OrenNayar,
                                      Mirror,
                                      Glass,
                                      Ggx,
                                      RoughGlass,
                                      Emission,
                                      Conductor,
                                      Dielectric,
                                      Polariser,
                                      Retarder,
                                      Fluorescent,
                                      Metal,
                                      MetallicRoughness,
                                      Phong,
                                      Plastic,
                                      AnisotropicGgx,
                                      GgxLambert,
                                      VaryingGgx,
                                      Blend>;

struct Material {
  std::string name;
  MaterialModel model;
  SurfaceDetail detail{};
  bool operator==(const Material&) const = default;
};

/// The word of the scene file for the model's type: "oren_nayar".
const char* type_name(const MaterialModel& model);

/// The texture of a material, if its model has one.
const std::optional<TextureUse>& texture_of(const MaterialModel& model);

/// All textures of a material: that of its model and those of its detail.
std::vector<TextureUse> texture_uses(const Material& material);

/// And of a blend those of its parts: all that a surface of the material shows.
std::vector<TextureUse> shown_texture_uses(const std::vector<Material>& materials, int index);

/// The spectrum that a model has in the place of its colour, if it has one.
const std::optional<SpectrumUse>& spectrum_of(const MaterialModel& model);

/// One entry of "materials". InputError at the key that is wrong.
/// `before` are those that stand before it, of which `names` are.
Material load_material(json::ObjectReader& in,
                       const Names& textures,
                       SpectralData& spectra,
                       const Names& names,
                       const std::vector<Material>& before);

}  // namespace orbs::scene

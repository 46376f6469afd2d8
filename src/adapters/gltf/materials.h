#pragma once

#include "adapters/format_limits.h"
#include "scene/scene.h"

#include <optional>
#include <string>

namespace orbs::adapters::gltf {

/// The levels beyond ORB.S that are written.
const BeyondOrbs& beyond_orbs();

/// Why the material cannot be written, "" when it can or when beyond_orbs says why not.
std::string material_limit(const scene::Material& material);

/// A material in the terms of glTF: its layers by baseColor, metallic and roughness, and the extensions
/// KHR_materials_specular, _ior, _transmission, _volume and _emissive_strength.
struct Surface {
  scene::RgbColour base_colour{};
  double metallic = 0;
  /// Perceptual: the square root of alpha. Where nothing is glossy it has no meaning in glTF, but Disney's
  /// diffuse reflection, which Blender has in the place of Lambert's law, depends on it. At 0.45 it reflects
  /// nearly as much: 1.0027 of all light from an even surrounding, and within 1.1 % towards all directions
  /// within 84 degrees of the normal. At 0.425 and 0.5, scene 113 is 1.0 % too dark and 0.6 % too bright; at
  /// 1, the default of glTF, an even surrounding gives 1.0645.
  double roughness = 0.45;
  double specular = 0;          // factor of the specular reflection of what is no metal
  std::optional<double> ior{};  // nothing: 1.5, which only a specular reflection would show
  bool is_glass = false;
  scene::RgbColour radiance{};  // both sides shine
};

/// The material as a surface. InputError when material_limit or beyond_orbs refuse its type.
Surface surface_of(const scene::Material& material);

}  // namespace orbs::adapters::gltf

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
  /// Perceptual: the square root of alpha. Where nothing is glossy it has no meaning, but Disney's diffuse
  /// reflection, which Blender has in the place of Lambert's law, is nearest to it at 0.5: its
  /// retro-reflection is 1 + (r (1 + cos) - 1/2)(...) with the angle between both directions, whose cosine
  /// averages about 0.
  double roughness = 0.5;
  double specular = 0;          // factor of the specular reflection of what is no metal
  std::optional<double> ior{};  // nothing: 1.5, which only a specular reflection would show
  bool is_glass = false;
  scene::RgbColour radiance{};  // both sides shine
};

/// The material as a surface. InputError when material_limit or beyond_orbs refuse its type.
Surface surface_of(const scene::Material& material);

}  // namespace orbs::adapters::gltf

#pragma once

#include "image/image.h"
#include "scene/scene.h"

#include <optional>
#include <string>

/// A light of HydraCore3 is three things: an entry of lights_lib, an instance of it, and a mesh of its own
/// shape with an instance that names both. Without the mesh it is invisible, and the integrator mispt loses
/// the light that sampling surfaces would find; with a mesh that does not name it, it counts twice. A light
/// without an area has no mesh.
namespace orbs::adapters::hydra {

/// Why the light cannot be written, "" when it can.
std::string light_limit(const scene::Light& light, const std::string& display_name);

/// The entry of lights_lib at that position; `ies_file` is the name of the file that holds its profile, and
/// `bright_lights` the number of lights that are not black, the environment among them.
std::string light_node(const scene::Light& light,
                       int position,
                       const std::string& ies_file,
                       int bright_lights);

/// An environment; images by their position in textures_lib.
struct Sky {
  scene::RgbColour radiance;
  std::optional<int> map = {};
  std::optional<int> back = {};  // what the camera sees in its place, across the image
};
/// The environment as an entry of lights_lib, which must be the last: materials count lights without it.
std::string sky_node(const Sky& sky, int position);
/// The image of an environment map in the axes of the world as HydraCore3 reads it, which shows skies
/// mirrored from left to right, and upside down in files whose first row is at the bottom.
image::Image sky_image(image::Image image);

/// The shape of the light in the light's own frame, with normals to where it shines and the one material 0.
scene::Mesh light_mesh(const scene::Light& light);

}  // namespace orbs::adapters::hydra

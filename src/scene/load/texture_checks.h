#pragma once

#include "scene/scene.h"

#include <string>
#include <vector>

namespace orbs::scene {

/// The complaint about a texture of floats that the scene's materials cannot use ("" if there is none):
/// texels that are not finite or negative, above 1 where they multiply a reflectance, and channels that are
/// no colours. Textures of integers are left unread: theirs lie in [0, 1].
std::string texture_problem(const Scene& scene, std::size_t texture);

/// A sentence for each mesh that is drawn with a textured material and has the same texture coordinates
/// wherever that shows, so that the texture is one texel. `mesh_places` say where the meshes stand in the
/// file.
std::vector<std::string> flat_texture_warnings(const Scene& scene,
                                               const std::vector<std::string>& mesh_places);

}  // namespace orbs::scene

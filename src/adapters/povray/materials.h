#pragma once

#include "scene/scene.h"

#include <string>

namespace orbs::adapters::povray {

/// What a surface does to rays decides how its triangles are grouped: glass needs an interior, which belongs
/// to a whole object, and mirrors and glass are what photons are aimed at.
enum class Surface { Plain, Mirror, Glass };
Surface surface_of(const scene::MaterialModel& model);

/// The texture image type that POV-Ray has for the file, by its extension ("png", "jpeg", ...), "" when it
/// has none.
std::string image_type(const std::filesystem::path& file);

/// Name of the copy of texture `index` beside a scene file of this stem.
std::string texture_copy(const scene::Scene& scene, int index, const std::string& stem);

/// `#declare Material<i> = texture {...}` with all layers.
std::string material_declaration(const scene::Scene& scene, int material, const std::string& stem);

}  // namespace orbs::adapters::povray

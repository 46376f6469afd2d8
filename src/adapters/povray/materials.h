#pragma once

#include "adapters/format_limits.h"
#include "scene/scene.h"

#include <filesystem>
#include <optional>
#include <string>

namespace orbs::adapters::povray {

/// What a surface does with light: mirrors and glass send photons to diffuse surfaces, and glass needs an
/// interior, which belongs to a whole object.
enum class Surface { Diffuse, Emitter, Mirror, Glass };

/// Nothing for a type of material that is not written.
std::optional<Surface> surface_of(const scene::MaterialModel& model);

/// Whether photons are aimed at surfaces of this material.
bool is_photon_target(const scene::MaterialModel& model);

/// The texture image type that POV-Ray has for the file, by its extension ("png", "jpeg", ...), "" when it
/// has none.
std::string image_type(const std::filesystem::path& file);

/// Name of the copy of texture `index` beside a scene file of this stem.
std::string texture_copy(const scene::Scene& scene, int index, const std::string& stem);

/// The levels beyond ORB.S that are written.
const BeyondOrbs& beyond_orbs();

/// Why the material cannot be written, "" when it can or when beyond_orbs says why not.
std::string material_limit(const scene::Scene& scene, const scene::Material& material);

/// `#declare Material<i> = texture {...}` with all layers. InputError when material_limit or beyond_orbs
/// refuse its type.
std::string material_declaration(const scene::Scene& scene, int material, const std::string& stem);

}  // namespace orbs::adapters::povray

#pragma once

#include "adapters/format_limits.h"
#include "adapters/pbrt/colours.h"

#include <string>

namespace orbs::adapters::pbrt {

/// The levels beyond ORB.S that are written.
const BeyondOrbs& beyond_orbs();

/// Why the material cannot be written, "" when it can or when beyond_orbs says why not.
std::string material_limit(const scene::Material& material);

/// The parameter of a shape by which it lets rays pass; "" where its material is opaque.
std::string alpha_text(const scene::Material& material, int index);

/// The name of a material: "material<i>", or of that for meshes whose frames are mirrored (split_by_frames).
std::string material_name(int material, bool is_mirrored);

/// Declares the material of that name. An emissive one reflects nothing; its radiance stands with its
/// shapes. InputError when material_limit or beyond_orbs refuse its type.
std::string material_text(const Colours& colours, int material, const std::string& stem, bool is_mirrored);

}  // namespace orbs::adapters::pbrt

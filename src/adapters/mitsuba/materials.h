#pragma once

#include "adapters/format_limits.h"
#include "adapters/mitsuba/colours.h"

#include <string>

namespace orbs::adapters::mitsuba {

/// The levels beyond ORB.S that are written.
const BeyondOrbs& beyond_orbs();

/// Why the material cannot be written, "" when it can or when beyond_orbs says why not. `is_polarised`: the
/// scene is for scalar_spectral_polarized.
std::string material_limit(const scene::Material& material, bool is_polarised);

/// The id of a material: "material<i>", or of that for meshes whose frames are mirrored (split_by_frames).
std::string bsdf_id(int material, bool is_mirrored);

/// `<bsdf id="...">` of that id. An emissive material reflects nothing; its radiance stands with its shapes.
/// InputError when material_limit or beyond_orbs refuse its type.
std::string bsdf_text(const Colours& colours, int material, const std::string& stem, bool is_mirrored);

}  // namespace orbs::adapters::mitsuba

#pragma once

#include "scene/scene.h"

#include <optional>
#include <string>

namespace orbs::adapters::povray {

/// The shape in POV-Ray's own words (quadric, torus, superellipsoid, isosurface, merge, ...), without closing
/// bracket, so that what belongs to the whole object can follow.
std::string open_shape_text(const scene::Shape& shape);

/// The mirror or glass that a shape shows, which POV-Ray gives an interior and photons; nothing without one.
std::optional<int> photon_material(const scene::Scene& scene, const scene::Shape& shape);

/// Why the shape cannot be written, "" when it can. `display_name` is the shape in the reason.
std::string shape_limit(const scene::Scene& scene,
                        const scene::Shape& shape,
                        const std::string& display_name);

}  // namespace orbs::adapters::povray

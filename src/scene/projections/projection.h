#pragma once

#include "scene/projections/latitude_longitude.h"
#include "scene/projections/orthographic.h"
#include "scene/projections/perspective.h"

#include <variant>

/// How a camera maps the world to its image. A projection is a struct with `kType`, its word in the scene
/// file, `kLevel`, the level that has it, and `kWhat`, as messages say it; and its functions ray_at and
/// scale, which enlarges it with the world.
namespace orbs::scene {

using Projection = std::variant<Perspective, Orthographic, LatitudeLongitude>;

}  // namespace orbs::scene

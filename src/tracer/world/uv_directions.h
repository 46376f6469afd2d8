#pragma once

#include "tracer/geometry/tangent_frame.h"
#include "tracer/world/world.h"

#include <optional>

namespace orbs::tracer {

/// How the point of a hit moves in the world with the coordinates that the map gives. Nothing where they are
/// all on one line, and on what is no mesh at rest.
std::optional<UvDirections> uv_directions_at(const World& world, const Hit& hit, const UvMap& map);

}  // namespace orbs::tracer

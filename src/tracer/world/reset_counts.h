#pragma once

#include "tracer/world/world.h"

namespace orbs::tracer {

/// Forgets what renders so far met at shapes by formula and of plug-ins: roots that stayed open, broken
/// rules.
void reset_counts(World& world);

}  // namespace orbs::tracer

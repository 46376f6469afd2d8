#pragma once

#include "tracer/world/world.h"

#include <memory>

namespace orbs::tracer {

/// Forgets what renders so far met at shapes by formula and of plug-ins: roots that stayed open, broken
/// rules.
inline void reset_counts(World& world) {
  for (auto& solid : world.solids) solid.counts = std::make_unique<RootCounts>();
  for (auto& shape : world.plugin_shapes) shape.faults = std::make_unique<PluginFaults>();
}

}  // namespace orbs::tracer

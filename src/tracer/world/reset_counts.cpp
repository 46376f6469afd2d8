#include "tracer/world/reset_counts.h"

#include <memory>

namespace orbs::tracer {

void reset_counts(World& world) {
  for (auto& solid : world.solids) solid.counts = std::make_unique<RootCounts>();
  for (auto& shape : world.plugin_shapes) shape.faults = std::make_unique<PluginFaults>();
}

}  // namespace orbs::tracer

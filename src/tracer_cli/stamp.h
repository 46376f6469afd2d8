#pragma once

#include "tracer/render/rendering.h"
#include "tracer/world/world.h"
#include "tracer_cli/options.h"

#include <string>

namespace orbs::tracer_cli {

/// Writes the attributes of the image: program, scene, settings and counters. Nothing in them depends on the
/// machine, the time or the number of threads, so the same seed gives the same bytes.
void stamp(tracer::Rendering& rendering,
           const Options& options,
           const scene::Scene& scene,
           const tracer::World& world,
           const std::string& version);

}  // namespace orbs::tracer_cli

#pragma once

#include "tracer/render/passes.h"
#include "tracer/render/rendering.h"
#include "tracer/world/world.h"

#include <functional>

/// The path loop once per transport. Each is instantiated in its own file, so that they compile in parallel
/// and a test can read from its symbols what it contains.
namespace orbs::tracer {

using PassRenderer = void(const World& world,
                          const RenderSettings& settings,
                          const NumberedPass& pass,
                          Film& film,
                          Rendering& out,
                          const std::function<void()>& tile_done);

/// render_pass of the cheapest transport that has what the world needs, or another integrator.
PassRenderer* kernel_for(const World& world);

}  // namespace orbs::tracer

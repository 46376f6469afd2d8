#pragma once

#include "tracer/render/rendering.h"
#include "tracer/world/world.h"

#include <atomic>
#include <functional>

namespace orbs::tracer {

/// Renders in passes of a few samples over the whole image. `stop` ends the rendering after the current pass
/// (the first pass is always completed); `report` is called from one thread at a time.
Rendering render(const World& world,
                 const RenderSettings& settings,
                 const std::atomic<bool>& stop,
                 const std::function<void(const Progress&)>& report);

}  // namespace orbs::tracer

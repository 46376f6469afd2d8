#pragma once

#include "tracer/render/passes.h"
#include "tracer/render/rendering.h"
#include "tracer/world/world.h"

#include <functional>

namespace orbs::tracer {

/// One pass of path tracing in which diffuse interreflection comes from a cache of irradiance (Ward,
/// Rubinstein and Clear 1988). It is biased: interpolation between records has an error that no samples per
/// pixel remove. The cache is used at the first Lambertian surface of a camera path that only delta functions
/// came before. Emitters and the environment that this surface sees, straight or by delta functions, are
/// sampled as ever, and so is all light where no record may be used. The first pass computes the records and
/// leaves them in `out`; `tile_done` as in PassRenderer.
void render_irradiance_cache(const World& world,
                             const RenderSettings& settings,
                             const NumberedPass& pass,
                             Film& film,
                             Rendering& out,
                             const std::function<void()>& tile_done);

}  // namespace orbs::tracer

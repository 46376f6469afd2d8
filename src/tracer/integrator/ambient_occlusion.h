#pragma once

#include "tracer/render/passes.h"
#include "tracer/render/rendering.h"
#include "tracer/world/world.h"

#include <functional>

namespace orbs::tracer {

/// One pass of ambient occlusion (Zhukov, Iones, Kronin 1998): the share of the hemisphere about the shading
/// normal in which no surface lies within the distance of the world's AmbientOcclusion of the point that the
/// camera sees, weighted by the cosine or evenly. Directions below the geometric surface are closed. Lights
/// are surfaces like others. Where the camera sees nothing, the image is 0. One ray for each sample;
/// `tile_done` as in PassRenderer.
void render_ambient_occlusion(const World& world,
                              const RenderSettings& settings,
                              const NumberedPass& pass,
                              Film& film,
                              Rendering& out,
                              const std::function<void()>& tile_done);

}  // namespace orbs::tracer

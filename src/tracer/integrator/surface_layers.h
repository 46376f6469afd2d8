#pragma once

#include "scene/scene.h"
#include "tracer/render/rendering.h"
#include "tracer/world/world.h"

namespace orbs::tracer {

/// Adds the layers of scene.outputs to the image, as image::kLayers defines them, the coverage before them
/// and the range of each mean behind it. They come from as many camera rays as the image has samples; each
/// ends at the first surface, with the light sources that have an area among them. What lets rays pass
/// (opacity) counts where it stops one. Adds the time to `out`.
///
/// Where the camera sees nothing, all layers are 0. `world` is that of the scene.
void add_surface_layers(const World& world,
                        const scene::Scene& scene,
                        const RenderSettings& settings,
                        Rendering& out);

}  // namespace orbs::tracer

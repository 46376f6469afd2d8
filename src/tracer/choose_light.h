#pragma once

#include "tracer/render/rendering.h"
#include "tracer/world/world.h"

namespace orbs::tracer {

/// Which choices are left to trial images.
struct LightChoices {
  bool selection = true;    // of emitters by the light BVH, learned or not, or by power: world.light_bvh
  bool paths = true;        // light paths for caustics: world.caustic_casters
  bool connections = true;  // to light vertices: world.connects_light_vertices
};

/// Keeps of these techniques what lowers the error of a trial image by more than its time costs, and empties
/// or unsets the others. All trial images together trace 7 % of the camera paths of the render that they are
/// for, with `settings`, learned light selection 2 % more, and guided light paths 5 %; if that is too little
/// to decide by, light paths alone are kept, as nothing else may find the light of a caustic. Deterministic.
/// Returns the time of the trials.
RenderTime choose_light(World& world, const RenderSettings& settings, LightChoices open = {});

}  // namespace orbs::tracer

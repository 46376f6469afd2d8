#pragma once

#include "scene/scene.h"

namespace orbs::adapters {

/// The scene with surfaces that shine in the place of its lights and of its environment, for formats that
/// have no lights with a size. What is drawn stays the same:
///   a light        a mesh of its shape and, a ten-thousandth of its size behind it, a black casing. Surfaces
///                  shine on both sides and lights on one, and the back of a light is black, opaque and
///                  visible. Disks and spheres have 128 segments and keep their area, so that their edge lies
///                  within 3e-4 radii of the round one.
///   an environment a box around all that is drawn, whose walls have its radiance: from inside, a closed
///                  surface that has one radiance everywhere looks the same whatever its shape and size.
/// Lights without an area stay. IES profiles and reflectances of lights are lost: refuse them before.
scene::Scene lights_as_meshes(scene::Scene scene);

}  // namespace orbs::adapters

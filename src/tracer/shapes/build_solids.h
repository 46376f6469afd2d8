#pragma once

#include "scene/scene.h"
#include "tracer/shapes/solid.h"

namespace orbs::tracer {

/// The shape in coordinates relative to `origin`.
Solid make_solid(const scene::Shape& shape, Vec3d origin);

}  // namespace orbs::tracer

#pragma once

#include "scene/scene.h"
#include "tracer/shapes/solid.h"

namespace orbs::tracer {

/// The shape in coordinates relative to `origin`.
Solid make_solid(const scene::Shape& shape, Vec3d origin);

/// InputError that names the shape, if one has had more than kMostUnfinished searches that did not end.
void refuse_unfinished_shapes(const std::vector<Solid>& solids);

}  // namespace orbs::tracer

#pragma once

#include "json/writer.h"
#include "scene/scene.h"

namespace orbs::scene {

/// Writes a shape as load_shape reads it.
void write_shape(json::Writer& out, const Scene& scene, const Shape& shape);

}  // namespace orbs::scene

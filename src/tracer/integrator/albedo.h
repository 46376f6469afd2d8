#pragma once

#include "tracer/world/surface.h"

namespace orbs::tracer {

/// What image::kLayers calls albedo: the colour that the entry of the material has as its reflectance, times
/// the texture. That of a blend is the weighted mean of its parts. 0 where the material has none, as glass
/// and emission.
Vec3f albedo_of(const World& world, const SurfaceHit& surface);

}  // namespace orbs::tracer

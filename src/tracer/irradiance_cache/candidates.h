#pragma once

#include "tracer/irradiance_cache/record.h"
#include "tracer/render/rendering.h"
#include "tracer/world/world.h"

#include <cstdint>
#include <vector>

namespace orbs::tracer {

/// A place that the camera sees, directly or by mirrors and glass, and where a record may be computed.
struct CacheCandidate {
  SurfaceElement at;
  Vec3f geometric_normal;
  int x = 0;  // pixel
  int y = 0;
  int scatterings = 0;   // of the path that led here
  float pixel_size = 0;  // width of the pixel at this place, in metres
};

/// One camera path through the centre of each pixel; those that meet a Lambertian surface before any other
/// that is not a delta function, in scanline order. `threads` as in RenderSettings.
std::vector<CacheCandidate> find_candidates(const World& world, const RenderSettings& settings);

}  // namespace orbs::tracer

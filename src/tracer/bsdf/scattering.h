#pragma once

#include "tracer/geometry/frame.h"

namespace orbs::tracer {

/// Where and how a path scatters, for what looks at more than the factor. Directions point away from the
/// surface.
template <typename Bsdf>
struct Scattering {
  const Bsdf& bsdf;
  Frame frame;  // the local one of the BSDF, in the world
  Vec3f to_viewer;
  Vec3f wo;  // to_viewer, local
  Vec3f wi;  // towards the light, local
};

}  // namespace orbs::tracer

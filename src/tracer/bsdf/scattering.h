#pragma once

#include "tracer/geometry/frame.h"

namespace orbs::tracer {

/// One scattering event of a path, for transports that need more than its factor. All directions point away
/// from the surface.
template <typename Bsdf>
struct Scattering {
  const Bsdf& bsdf;
  Frame frame;  // from the local frame of the BSDF to the world
  Vec3f to_viewer;
  Vec3f wo;  // to_viewer in the local frame
  Vec3f wi;  // towards the light, in the local frame
};

}  // namespace orbs::tracer

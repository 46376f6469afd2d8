#pragma once

#include "base/vec.h"

/// What each kind of camera says of its image. The window reaches from -1 to 1 in x and y, to the right and
/// up. `view` has the vectors of Camera, in float or, of a distant camera, in double.
namespace orbs::tracer {

/// The ray through a point of the window; its direction need not be unit.
template <typename Real>
struct FilmRay {
  Vec3<Real> origin;
  Vec3<Real> direction;
};

/// Where the camera sees a point. The mean over the window is the integral of what is seen over surfaces
/// perpendicular to the rays, divided by `window * spread`; a place without a spread is none.
struct FilmPlace {
  float x = 0;
  float y = 0;
  Vec3f viewpoint;   // where the ray through the point begins
  float window = 1;  // the measure of the window
  float spread = 0;  // of the surface over that measure
};

}  // namespace orbs::tracer

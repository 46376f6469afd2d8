#pragma once

#include "base/vec.h"

namespace orbs::scene {

/// Where a camera stands, by gluLookAt (side = forward x up, true up = side x forward), and the window
/// through which it looks. All three vectors are unit and in world space. The edges of the window lie at
/// centre +- half size along `right` and `up`: on the plane at distance 1 of a perspective, in metres of an
/// orthographic camera, in radians of a latitude-longitude image.
struct CameraFrame {
  Vec3d forward;
  Vec3d right;
  Vec3d up;
  double half_width = 1;
  double half_height = 1;
  Vec2d centre{};  // not 0 where the lens is shifted
};

/// What one point of the image shows lies along this ray.
struct CameraRay {
  Vec3d origin_m;
  Vec3d direction;
};

}  // namespace orbs::scene

#pragma once

#include "scene/scene.h"

namespace orbs::scene {

/// The image plane at distance 1 of the camera, by gluLookAt (side = forward x up, true up = side x forward)
/// and glFrustum. The middle of the image lies at `forward`, its edges at +-right half_width and +-up
/// half_height; all three vectors are unit and in world space.
struct CameraFrame {
  Vec3d forward;
  Vec3d right;
  Vec3d up;
  double half_width = 1;
  double half_height = 1;
};

CameraFrame camera_frame(const Camera& camera);

}  // namespace orbs::scene

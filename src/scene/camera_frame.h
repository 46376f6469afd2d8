#pragma once

#include "scene/scene.h"

#include <cmath>
#include <numbers>

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

inline CameraFrame camera_frame(const Camera& camera) {
  CameraFrame frame;
  frame.forward = normalised(camera.look_at_m - camera.position_m);
  frame.right = normalised(cross(frame.forward, camera.up));
  frame.up = cross(frame.right, frame.forward);
  frame.half_height = std::tan(camera.fov_y_deg * std::numbers::pi / 360);
  frame.half_width = frame.half_height * camera.width_px / camera.height_px;
  return frame;
}

}  // namespace orbs::scene

#include "scene/camera_frame.h"

#include <cmath>
#include <numbers>

namespace orbs::scene {

CameraFrame camera_frame(const Camera& camera) {
  CameraFrame frame;
  frame.forward = normalised(camera.look_at_m - camera.position_m);
  frame.right = normalised(cross(frame.forward, camera.up));
  frame.up = cross(frame.right, frame.forward);
  frame.half_height = std::tan(camera.fov_y_deg * std::numbers::pi / 360);
  frame.half_width = frame.half_height * camera.width_px / camera.height_px;
  return frame;
}

}  // namespace orbs::scene

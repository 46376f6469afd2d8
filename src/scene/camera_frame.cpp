#include "scene/camera_frame.h"

#include <cmath>
#include <numbers>

namespace orbs::scene {

namespace {

struct SetWindow {
  const Camera& camera;
  CameraFrame& frame;

  void operator()(const Perspective&) const {
    set_half_height(std::tan(camera.fov_y_deg * std::numbers::pi / 360));
    frame.centre = {2 * camera.shift.x * frame.half_width, 2 * camera.shift.y * frame.half_height};
  }
  void operator()(const Orthographic& projection) const { set_half_height(projection.height_m / 2); }
  void operator()(const LatitudeLongitude&) const {
    frame.half_width = std::numbers::pi;
    frame.half_height = std::numbers::pi / 2;
  }
  void set_half_height(double half_height) const {
    frame.half_height = half_height;
    frame.half_width = half_height * camera.width_px / camera.height_px;
  }
};

}  // namespace

CameraFrame camera_frame(const Camera& camera) {
  CameraFrame frame;
  frame.forward = normalised(camera.look_at_m - camera.position_m);
  frame.right = normalised(cross(frame.forward, camera.up));
  frame.up = cross(frame.right, frame.forward);
  std::visit(SetWindow{camera, frame}, camera.projection);
  return frame;
}

CameraRay camera_ray(const Camera& camera, const CameraFrame& frame, double x_px, double y_px) {
  const double x = (2 * x_px / camera.width_px - 1) * frame.half_width + frame.centre.x;
  const double y = (1 - 2 * y_px / camera.height_px) * frame.half_height + frame.centre.y;
  return std::visit([&](const auto& kind) { return ray_at(kind, frame, camera.position_m, x, y); },
                    camera.projection);
}

bool is_plain_pinhole(const Camera& camera) {
  return is_perspective(camera) && !has_lens(camera) && !is_shifted(camera);
}

}  // namespace orbs::scene

#include "peers/scenes.h"

#include "scene/camera_frame.h"

#include <cmath>
#include <numbers>

namespace orbs::peers {

Vec3d pixel_direction(const scene::Camera& camera, double x_px, double y_px) {
  const auto frame = scene::camera_frame(camera);
  const double x = (2 * (x_px + 0.5) / camera.width_px - 1) * frame.half_width;
  const double y = (1 - 2 * (y_px + 0.5) / camera.height_px) * frame.half_height;
  return normalised(frame.forward + frame.right * x + frame.up * y);
}

scene::Scene tilted_camera_before_quad(Vec3d radiance) {
  auto scene = empty_scene(64, 24, 50);
  scene.camera.position_m = {1, 2, 3};
  scene.camera.look_at_m = {-2, 1, 7};
  scene.camera.up = {0.2, 1, 0.1};
  const Vec3d forward = normalised(scene.camera.look_at_m - scene.camera.position_m);
  const auto at = [&](double x, double y) {
    const Vec3d direction = pixel_direction(scene.camera, x - 0.5, y - 0.5);
    return scene.camera.position_m + direction * (2 / dot(direction, forward));
  };
  add_instance(scene, quad(at(37, 9), at(45, 9) - at(37, 9), at(37, 2) - at(37, 9)),
               add_material(scene, scene::Emission{radiance, {}}));
  return scene;
}

scene::Scene floor_scene() {
  auto scene = empty_scene(24, 24, 90);
  scene.camera.position_m = {0, 0.5, 0};
  scene.camera.look_at_m = {0, 0, 0};
  scene.camera.up = {0, 0, -1};
  add_instance(scene, quad({-9, 0, 9}, {18, 0, 0}, {0, 0, -18}),
               add_material(scene, scene::Lambert{{kFloorAlbedo, kFloorAlbedo, kFloorAlbedo}, {}}));
  return scene;
}

Vec3d floor_point(const scene::Scene& scene, int x, int y) {
  const Vec3d direction = pixel_direction(scene.camera, x, y);
  return scene.camera.position_m + direction * (scene.camera.position_m.y / -direction.y);
}

// F = 1/(2 pi) |sum of angle(v_i, v_i+1) n .
// unit(v_i x v_i+1)|.
double polygon_factor(Vec3d receiver, const std::array<Vec3d, 4>& corners) {
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3d a = normalised(corners[i] - receiver);
    const Vec3d b = normalised(corners[(i + 1) % 4] - receiver);
    const Vec3d across = cross(a, b);
    sum += std::atan2(length(across), dot(a, b)) * across.y / length(across);
  }
  return std::abs(sum) / (2 * std::numbers::pi);
}

}  // namespace orbs::peers

#include "peers/scenes.h"

#include "scene/camera_frame.h"

#include <algorithm>
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

scene::Scene lamp_in_mirror(scene::RgbColour reflectance) {
  auto scene = empty_scene(9, 9, 60);
  scene.trace_depth = 2;
  add_instance(scene, quad({-9, -9, -2}, {18, 0, 0}, {0, 18, 0}),
               add_material(scene, scene::Mirror{reflectance}));
  add_instance(scene, quad({0.01, -9, 3}, {9, 0, 0}, {0, 18, 0}),
               add_material(scene, scene::Emission{{2, 2, 2}, {}}));
  return scene;
}

scene::Scene glass_ball_in_uniform_light(int trace_depth) {
  auto scene = empty_scene(16, 16, 40);
  scene.trace_depth = trace_depth;
  scene.environment.radiance = {1, 1, 1};
  add_instance(scene, scene::make_sphere({.radius_m = 1, .segments = 64}),
               add_material(scene, scene::Glass{{1, 1, 1}, 1.5}), translation({0, 0, -4}));
  return scene;
}

scene::Scene glass_slab(int size_px, int trace_depth) {
  auto scene = empty_scene(size_px, size_px, 2);
  scene.trace_depth = trace_depth;
  add_instance(scene, scene::make_cube({1}), add_material(scene, scene::Glass{{1, 1, 1}, 1.5}),
               translation({0, 0, -3}) * scaling({9, 9, 0.25}));
  add_instance(scene, quad({-99, -99, -6}, {198, 0, 0}, {0, 198, 0}),
               add_material(scene, scene::Emission{{1, 1, 1}, {}}));
  return scene;
}

scene::Scene integrating_sphere(int size_px, int segments) {
  auto scene = empty_scene(size_px, size_px, 60);
  scene.camera.look_at_m = {0, -1, -0.2};
  const int lamp = add_material(scene, scene::Emission{{1, 1, 1}, {}});
  const int wall = add_material(scene, scene::Lambert{{0.5, 0.5, 0.5}, {}});
  add_instance(scene, scene::make_sphere({.radius_m = 2, .segments = segments}), wall);
  auto& materials = scene.meshes[0].triangle_materials;
  std::fill(materials.begin(), materials.begin() + static_cast<std::ptrdiff_t>(materials.size() / 2), lamp);
  return scene;
}

}  // namespace orbs::peers

#pragma once

#include "image/image.h"
#include "scene/geometry/generators.h"
#include "scene/scene.h"

#include <array>
#include <string>
#include <vector>

/// Small scenes for real renderers, built without a file, and what they must look like.
namespace orbs::peers {

/// Camera at the origin looking along -Z, one material per call of add_material.
inline scene::Scene empty_scene(int width_px, int height_px, double fov_y_deg) {
  scene::Scene scene;
  scene.camera.look_at_m = {0, 0, -1};
  scene.camera.fov_y_deg = fov_y_deg;
  scene.camera.width_px = width_px;
  scene.camera.height_px = height_px;
  scene.trace_depth = 1;
  return scene;
}

inline int add_material(scene::Scene& scene, const scene::MaterialModel& model) {
  scene.materials.push_back({"m" + std::to_string(scene.materials.size()), model});
  return static_cast<int>(scene.materials.size()) - 1;
}

inline void add_instance(scene::Scene& scene, scene::Mesh mesh, int material, const Mat4& matrix = {}) {
  mesh.triangle_materials.assign(mesh.triangles.size(), material);
  mesh.name = "mesh" + std::to_string(scene.meshes.size());
  scene.meshes.push_back(std::move(mesh));
  const int index = static_cast<int>(scene.meshes.size()) - 1;
  scene.instances.push_back({"i" + std::to_string(index), index, matrix, {}});
}

/// Corner, then the corners at its ends of u and v; coordinates run from 0 to `repeat`.
inline scene::Mesh quad(Vec3d corner, Vec3d edge_u, Vec3d edge_v, double low = 0, double high = 1) {
  scene::Mesh mesh;
  const Vec3f normal = cast<float>(normalised(cross(edge_u, edge_v)));
  const auto l = static_cast<float>(low);
  const auto h = static_cast<float>(high);
  for (const Vec3d p : {corner, corner + edge_u, corner + edge_u + edge_v, corner + edge_v})
    mesh.positions.push_back(cast<float>(p));
  mesh.normals.assign(4, normal);
  mesh.tangents.assign(4, {});
  mesh.uvs = {{l, l}, {h, l}, {h, h}, {l, h}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

inline double value(const image::Image& image, int x_px, int y_px, std::size_t channel = 0) {
  return static_cast<double>(image.at(x_px, y_px, channel));
}

/// Unit direction through the centre of a pixel, as gluLookAt and glFrustum put it.
Vec3d pixel_direction(const scene::Camera& camera, double x_px, double y_px);

/// A turned and tilted camera of 64 x 24 pixels before an emitting quad that covers exactly the pixels
/// [37, 45) x [2, 9).
scene::Scene tilted_camera_before_quad(Vec3d radiance);
inline bool is_on_tilted_quad(int x_px, int y_px) { return x_px >= 37 && x_px < 45 && y_px >= 2 && y_px < 9; }

/// A Lambert floor of albedo 0.5 at y = 0, seen from 0.5 m above; 24 x 24 pixels of it, 1 m wide. No light.
scene::Scene floor_scene();
inline constexpr double kFloorAlbedo = 0.5;

/// The floor's point in the middle of a pixel.
Vec3d floor_point(const scene::Scene& scene, int x_px, int y_px);

/// Form factor of a quad at a point of a floor whose normal is +Y, by Lambert's polygon formula: a Lambert
/// floor shows albedo * radiance * factor. The quad lies above the horizon.
double polygon_factor(Vec3d receiver, const std::array<Vec3d, 4>& corners);

/// A lamp of radiance 2 behind the camera, to the right, and a mirror before it that fills the image of 9 x
/// 9 pixels: L = R L_e exactly, left and right exchanged.
scene::Scene lamp_in_mirror(scene::RgbColour reflectance);

/// A ball of glass in a uniform environment of radiance 1. No absorption: it cannot be told from nothing, at
/// any angle, once enough interreflections are followed.
scene::Scene glass_ball_in_uniform_light(int trace_depth);

/// A slab of glass before an emitter of radiance 1, at normal incidence; what is reflected meets black.
scene::Scene glass_slab(int size_px, int trace_depth);
/// T = (1 - R) / (1 + R), R = ((n - 1) / (n + 1))^2 = 0.04.
inline constexpr double kSlabTransmission = 0.96 / 1.04;

/// A sphere from within, where each point sees every other by the same factor: the northern half emits 1, the
/// southern half, which fills the image, reflects 0.5.
scene::Scene integrating_sphere(int size_px, int segments);

}  // namespace orbs::peers

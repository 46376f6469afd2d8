#pragma once

#include "adapters/povray/povray.h"
#include "image/image_io.h"
#include "scene/generators.h"

#include <string>
#include <vector>

/// Small scenes for the real POV-Ray, built without a file.
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

/// Unit direction through the centre of a pixel, as gluLookAt and glFrustum put it.
Vec3d pixel_direction(const scene::Camera& camera, double x_px, double y_px);

/// Writes the scene, starts POV-Ray in a folder of its own, reads the picture. One ray through each pixel's
/// centre. std::runtime_error with a clear sentence when POV-Ray is not installed or fails.
image::Image render_with_povray(const scene::Scene& scene,
                                const std::string& name,
                                const adapters::PovraySettings& settings = {},
                                const std::vector<std::string>& options = {"-A"});

}  // namespace orbs::peers

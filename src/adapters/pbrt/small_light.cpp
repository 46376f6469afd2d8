#include "adapters/pbrt/small_light.h"

#include "adapters/light_frame.h"

#include <fmt/format.h>

namespace orbs::adapters::pbrt {

namespace {

// One of 3000 diffuse reflections meets a light of this size. The largest that is refused (2.7e-6 sr,
// caustic_BK7) left the mean 300 % uncertain at the samples of its case; the smallest that is let through
// (0.05 sr) converges like the rest of its image.
constexpr double kLeastSolidAngle_sr = 1e-3;

bool is_smooth_glass(const scene::MaterialModel& model) {
  if (const auto* dielectric = std::get_if<scene::Dielectric>(&model)) return !dielectric->roughness;
  return std::holds_alternative<scene::Glass>(model);
}

// Of a sphere that of a disk, which is what is seen of it.
double area_m2(const scene::Light& light) {
  const LightFrame frame = light_frame(light.matrix);
  return length(cross(frame.u, frame.v)) *
         std::visit([](const auto& shape) { return cross_section_m2(shape); }, light.shape);
}

Vec3d middle_m(const scene::Mesh& mesh, const Mat4& place) {
  Vec3d sum;
  for (const auto position : mesh.positions) sum += cast<double>(position);
  return transform_point(place, sum / static_cast<double>(mesh.positions.size()));
}

}  // namespace

std::string small_light_limit(const scene::Scene& scene, const std::vector<MaterialMesh>& meshes) {
  for (const MaterialMesh& shown : meshes) {
    if (!is_smooth_glass(material_at(scene, shown.material).model)) continue;
    for (const Mat4& place : shown.places)
      for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const scene::Light& light = scene.lights[i];
        const Vec3d between = transform_point(light.matrix, {}) - middle_m(shown.mesh, place);
        const double solid_angle_sr = area_m2(light) / dot(between, between);
        if (solid_angle_sr < kLeastSolidAngle_sr)
          return fmt::format(
              "{} fills {:.2g} sr as seen from mesh '{}', which is smooth glass: pbrt's path integrator meets "
              "what shines through glass by chance only, and needs {} sr",
              scene::display_name("light", light.name, i), solid_angle_sr, shown.mesh.name,
              kLeastSolidAngle_sr);
      }
  }
  return "";
}

}  // namespace orbs::adapters::pbrt

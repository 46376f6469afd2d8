#include "scene/lower/lower.h"

#include "base/nth.h"
#include "scene/effects/effects.h"
#include "scene/effects/features.h"
#include "scene/lower/geometry.h"
#include "scene/motion.h"

#include <map>
#include <utility>

#include <fmt/format.h>

namespace orbs::scene {

void drop_spectra(Scene& scene) {
  for (auto& material : scene.materials)
    std::visit(
        [](auto& model) {
          if constexpr (requires { model.spectrum; }) model.spectrum.reset();
        },
        material.model);
  for (auto& light : scene.lights) light.spectrum.reset();
  scene.environment.spectrum.reset();
  scene.spectra.clear();
}

namespace {

// All textures of a material have the same one where they are baked (check_texture_matrices).
bool has_texture_matrix(const std::vector<Material>& materials, int index) {
  const auto uses = shown_texture_uses(materials, index);
  return !uses.empty() && uses.front().matrix != Mat4{};
}

Vec2f transformed(const Mat4& m, Vec2f uv) {
  const double u = static_cast<double>(uv.x);
  const double v = static_cast<double>(uv.y);
  return {static_cast<float>(m(0, 0) * u + m(0, 1) * v + m(0, 3)),
          static_cast<float>(m(1, 0) * u + m(1, 1) * v + m(1, 3))};
}

// Those of the last vertex.
void transform_uvs(Mesh& mesh, const Mat4& matrix) {
  mesh.uvs.back() = transformed(matrix, mesh.uvs.back());
  if (!mesh.second_uvs.empty()) mesh.second_uvs.back() = transformed(matrix, mesh.second_uvs.back());
}

// Triangles of different materials may share vertices, whose coordinates then differ: each material gets a
// separate vertex.
void bake_texture_matrices(Mesh& mesh, const std::vector<Material>& materials) {
  constexpr int kAsIs = -1;
  std::map<std::pair<std::uint32_t, int>, std::uint32_t> places;
  Mesh out;
  out.name = mesh.name;
  out.triangle_materials = mesh.triangle_materials;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const int index = mesh.triangle_materials[i];
    const bool has_matrix = has_texture_matrix(materials, index);
    auto& triangle = out.triangles.emplace_back(mesh.triangles[i]);
    for (auto& vertex : triangle) {
      const auto place = static_cast<std::uint32_t>(out.positions.size());
      const auto [it, is_new] = places.try_emplace({vertex, has_matrix ? index : kAsIs}, place);
      if (is_new) {
        append_vertex(out, mesh, vertex);
        if (has_matrix) transform_uvs(out, shown_texture_uses(materials, index).front().matrix);
      }
      vertex = it->second;
    }
  }
  mesh = std::move(out);
}

}  // namespace

void replace_smooth_oren_nayar(Scene& scene) {
  for (auto& material : scene.materials) {
    const auto* model = std::get_if<OrenNayar>(&material.model);
    if (model == nullptr || model->roughness != 0) continue;
    // eq. 5 with sigma = 0: A = 1, B = 0
    material.model = Lambert{model->reflectance, model->texture, model->spectrum};
  }
}

void replace_plain_dielectrics(Scene& scene) {
  constexpr double kAnywhere_nm = 550;
  for (auto& material : scene.materials) {
    const auto* glass = std::get_if<Dielectric>(&material.model);
    if (glass == nullptr || !is_smooth_glass(*glass) || is_dispersive(*glass)) continue;
    material.model =
        Glass{{1, 1, 1}, index_at(glass->index, kAnywhere_nm) / index_at(glass->outside, kAnywhere_nm)};
  }
}

void bake_texture_matrices(Scene& scene) {
  bool any = false;
  for (std::size_t i = 0; i < scene.materials.size(); ++i)
    any = any || has_texture_matrix(scene.materials, static_cast<int>(i));
  if (!any) return;
  resolve_remap_lists(scene);
  for (auto& mesh : scene.meshes) bake_texture_matrices(mesh, scene.materials);
  for (auto& material : scene.materials) {
    std::visit(
        [](auto& model) {
          if constexpr (requires { model.texture; })
            if (model.texture) model.texture->matrix = Mat4{};
        },
        material.model);
    SurfaceDetail& detail = material.detail;
    if (detail.opacity_texture) detail.opacity_texture->matrix = Mat4{};
    if (detail.normal_map) detail.normal_map->texture.matrix = Mat4{};
    if (detail.bump_map) detail.bump_map->texture.matrix = Mat4{};
  }
}

std::string texture_matrices_problem(const Scene& scene, int material) {
  const auto uses = shown_texture_uses(scene.materials, material);
  for (const TextureUse& use : uses)
    if (use.matrix != uses.front().matrix)
      return fmt::format("material '{}' has textures with different matrices",
                         material_at(scene, material).name);
  return "";
}

namespace {

// The first feature beyond the capabilities, as a reason; "" when there is none.
std::string lacking(const std::vector<CalledFeature>& features, const Capabilities& capabilities) {
  for (const auto& feature : features)
    if (!capabilities.contains(feature.requirement))
      return fmt::format("{}, which needs {}", feature.what, feature.requirement);
  return "";
}

std::string lower_lights(Scene& scene, const Capabilities& capabilities) {
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    auto& light = scene.lights[i];
    const auto problem =
        std::visit([&](const auto& shape) { return beyond_levels(shape, light.matrix); }, light.shape);
    if (!problem.empty()) return display_name("light", light.name, i) + " " + problem;
    // The levels of a light without an area have it wherever it stands and shines to.
    if (capabilities.contains("L3") || !has_area(light.shape)) continue;
    const auto moved = without_matrix(light);
    if (!moved)
      return display_name("light", light.name, i) +
             " is turned or scaled in a way that its sizes cannot take up, which needs L3";
    light = *moved;
  }
  return lacking(features_of_lights(scene), capabilities);
}

std::string lower_materials(Scene& scene, const Capabilities& capabilities) {
  if (!capabilities.contains("M7")) replace_smooth_oren_nayar(scene);
  if (!capabilities.contains("E1")) replace_plain_dielectrics(scene);
  if (!capabilities.contains("M5")) {
    for (const int index : visible_materials(scene))
      if (auto problem = texture_matrices_problem(scene, index); !problem.empty())
        return problem + ", which needs M5";
    bake_texture_matrices(scene);
  }
  if (!capabilities.contains("N6"))  // a texture that asks for them is refused
    for (auto& mesh : scene.meshes) mesh.second_uvs.clear();
  return lacking(features_of_materials(scene), capabilities);
}

std::string lower_effects(Scene& scene, const Capabilities& capabilities) {
  if (!capabilities.contains("E2") && !calls_for(effects(scene), Effect::Spectral)) drop_spectra(scene);
  return lacking(features_of_effects(scene), capabilities);
}

// Their triangles are there already.
void drop_subdivision(Scene& scene, const Capabilities& capabilities) {
  for (auto& mesh : scene.meshes)
    if (mesh.subdivision &&
        !(capabilities.contains("S5") && (capabilities.contains("S6") || !mesh.subdivision->displacement)))
      mesh.subdivision.reset();
}

std::string lower_geometry(Scene& scene, const Capabilities& capabilities) {
  if (has_moving_objects(scene) && !capabilities.contains("G3"))
    return "something moves, and one mesh in world space cannot, which needs G3";
  drop_subdivision(scene, capabilities);
  if (!capabilities.contains("S1")) tessellate_spheres(scene);
  for (const char* level : {"S1", "S2"})
    if (!capabilities.contains(level)) tessellate_shapes(scene, level);
  if (const auto reason = lacking(features_of_shapes(scene), capabilities); !reason.empty()) return reason;
  if (!capabilities.contains("G1") && !capabilities.contains("G2"))
    return "the scene is made of triangles, which needs G1";
  if (!capabilities.contains("G3")) {
    merge_into_world_mesh(scene);
  } else if (capabilities.contains("G5")) {
    return "";
  } else if (capabilities.contains("G4")) {
    split_by_material(scene);
  } else {
    resolve_remap_lists(scene);
  }
  return "";
}

}  // namespace

std::variant<Scene, std::string> lower(const Scene& scene, const Capabilities& capabilities) {
  Scene lowered = scene;
  for (const auto& features :
       {features_of_integrator(scene), features_of_motion(scene), features_of_camera(scene),
        features_of_environment(scene), features_of_outputs(scene)})
    if (auto reason = lacking(features, capabilities); !reason.empty()) return reason;
  for (auto* const step : {lower_materials, lower_effects, lower_lights, lower_geometry})
    if (auto reason = step(lowered, capabilities); !reason.empty()) return reason;
  return lowered;
}

}  // namespace orbs::scene

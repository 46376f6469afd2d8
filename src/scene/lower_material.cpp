#include "scene/effects.h"
#include "scene/lower_parts.h"

#include <map>
#include <utility>

#include <fmt/format.h>

namespace orbs::scene {

namespace {

struct Need {
  const char* requirement;
  const char* what;
};

bool is_plain(const Dielectric& glass) { return !glass.roughness && !glass.film; }

// No M level defines glossy reflection and rough glass: ORB.S brings them with the paths of A2 and A4. Group
// E is ours.
struct ModelNeed {
  Need operator()(const Lambert&) const { return {"M1", "Lambertian"}; }
  Need operator()(const OrenNayar&) const { return {"M7", "Oren-Nayar"}; }
  Need operator()(const Mirror&) const { return {"M3", "a mirror"}; }
  Need operator()(const Glass&) const { return {"M8", "smooth glass"}; }
  Need operator()(const Ggx&) const { return {"A2", "a glossy reflector (GGX)"}; }
  Need operator()(const RoughGlass&) const { return {"A4", "rough glass"}; }
  Need operator()(const Emission&) const { return {"M2", "emissive"}; }
  Need operator()(const Conductor&) const { return {"E1", "a conductor by its indices"}; }
  // Where it disperses the effect calls for E6; how its index is written down is no matter of the interface.
  Need operator()(const Dielectric& m) const {
    return is_plain(m) ? Need{"M8", "smooth glass"} : Need{"E1", "a dielectric by its indices"};
  }
  Need operator()(const Polariser&) const { return {"E3", "a polariser"}; }
  Need operator()(const Retarder&) const { return {"E3", "a retarder"}; }
  Need operator()(const Fluorescent&) const { return {"E4", "fluorescent"}; }
};

std::optional<TextureUse>* texture_slot(MaterialModel& model) {
  if (auto* lambert = std::get_if<Lambert>(&model)) return &lambert->texture;
  if (auto* oren_nayar = std::get_if<OrenNayar>(&model)) return &oren_nayar->texture;
  if (auto* emission = std::get_if<Emission>(&model)) return &emission->texture;
  return nullptr;
}

bool has_texture_matrix(const Material& material) {
  const auto& use = texture_of(material.model);
  return use && use->matrix != Mat4{};
}

Vec2f transformed(const Mat4& m, Vec2f uv) {
  const double u = static_cast<double>(uv.x);
  const double v = static_cast<double>(uv.y);
  return {static_cast<float>(m(0, 0) * u + m(0, 1) * v + m(0, 3)),
          static_cast<float>(m(1, 0) * u + m(1, 1) * v + m(1, 3))};
}

// Triangles of different materials may share vertices, whose coordinates then differ: each gets its own.
void bake_texture_matrices(Mesh& mesh, const std::vector<Material>& materials) {
  constexpr int kAsIs = -1;
  std::map<std::pair<std::uint32_t, int>, std::uint32_t> places;
  Mesh out;
  out.name = mesh.name;
  out.triangle_materials = mesh.triangle_materials;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const int index = mesh.triangle_materials[i];
    const auto& material = materials[static_cast<std::size_t>(index)];
    const bool has_matrix = has_texture_matrix(material);
    auto& triangle = out.triangles.emplace_back(mesh.triangles[i]);
    for (auto& vertex : triangle) {
      const auto place = static_cast<std::uint32_t>(out.positions.size());
      const auto [it, is_new] = places.try_emplace({vertex, has_matrix ? index : kAsIs}, place);
      if (is_new) {
        out.positions.push_back(mesh.positions[vertex]);
        out.normals.push_back(mesh.normals[vertex]);
        out.tangents.push_back(mesh.tangents[vertex]);
        const Vec2f uv = mesh.uvs[vertex];
        out.uvs.push_back(has_matrix ? transformed(texture_of(material.model)->matrix, uv) : uv);
      }
      vertex = it->second;
    }
  }
  mesh = std::move(out);
}

}  // namespace

std::set<int> visible_materials(const Scene& scene) {
  std::set<int> visible;
  for (const auto& instance : scene.instances) {
    const auto& materials = scene.meshes[static_cast<std::size_t>(instance.mesh)].triangle_materials;
    for (const int material : std::set<int>(materials.begin(), materials.end()))
      visible.insert(remapped(instance, material));
  }
  for (const auto& sphere : scene.spheres) visible.insert(sphere.material);
  return visible;
}

std::vector<CalledFeature> features_of_materials(const Scene& scene) {
  std::vector<CalledFeature> features;
  for (const int index : visible_materials(scene)) {
    const auto& material = scene.materials[static_cast<std::size_t>(index)];
    const auto need = std::visit(ModelNeed{}, material.model);
    const auto note = [&](const char* requirement, const std::string& what) {
      features.push_back({requirement, fmt::format("material '{}' {}", material.name, what)});
    };
    note(need.requirement, fmt::format("is {}", need.what));
    if (!texture_of(material.model)) continue;
    note(std::holds_alternative<Emission>(material.model) ? "M6" : "M4", "has a texture");
    if (has_texture_matrix(material)) note("M5", "has a texture matrix");
  }
  return features;
}

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
    if (glass == nullptr || !is_plain(*glass) || is_dispersive(*glass)) continue;
    material.model =
        Glass{{1, 1, 1}, index_at(glass->index, kAnywhere_nm) / index_at(glass->outside, kAnywhere_nm)};
  }
}

void bake_texture_matrices(Scene& scene) {
  bool any = false;
  for (const auto& material : scene.materials) any = any || has_texture_matrix(material);
  if (!any) return;
  resolve_remap_lists(scene);
  for (auto& mesh : scene.meshes) bake_texture_matrices(mesh, scene.materials);
  for (auto& material : scene.materials)
    if (has_texture_matrix(material)) (*texture_slot(material.model))->matrix = Mat4{};
}

}  // namespace orbs::scene

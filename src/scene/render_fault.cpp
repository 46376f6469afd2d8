#include "scene/render_fault.h"

#include "image/image_io.h"
#include "scene/camera_frame.h"
#include "scene/mirrored_frames.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

namespace orbs::scene {

namespace {

Vec3d column(const Mat4& m, std::size_t c) { return {m(0, c), m(1, c), m(2, c)}; }

// Such a matrix turns normals as it turns directions: its columns are perpendicular and of one length.
bool keeps_angles(const Mat4& m) {
  constexpr double kNear = 1e-9;
  const double square = dot(column(m, 0), column(m, 0));
  const auto is_near = [&](std::size_t a, std::size_t b, double wanted) {
    return std::abs(dot(column(m, a), column(m, b)) - wanted) <= kNear * square;
  };
  return is_near(1, 1, square) && is_near(2, 2, square) && is_near(0, 1, 0) && is_near(0, 2, 0) &&
         is_near(1, 2, 0);
}

// The inverse transpose maps M^T M n to M n.
Vec3d mapped_twice(const Mat4& m, Vec3d n) {
  const Vec3d once = column(m, 0) * n.x + column(m, 1) * n.y + column(m, 2) * n.z;
  return {dot(column(m, 0), once), dot(column(m, 1), once), dot(column(m, 2), once)};
}

// Each instance that the fault concerns gets a mesh of its own.
void map_normals_by_matrix(Scene& scene) {
  for (auto& instance : scene.instances) {
    if (keeps_angles(instance.matrix) || mesh_of(scene, instance).normals.empty()) continue;
    auto mesh = mesh_of(scene, instance);
    mesh.name += " of " + std::to_string(&instance - scene.instances.data());
    for (auto& normal : mesh.normals)
      normal = cast<float>(normalised(mapped_twice(instance.matrix, cast<double>(normal))));
    mesh.subdivision.reset();
    instance.mesh = static_cast<int>(scene.meshes.size());
    scene.meshes.push_back(std::move(mesh));
  }
}

void turn_environment(Scene& scene, const Mat4& turn) {
  scene.environment.map->matrix = turn * scene.environment.map->matrix;
}

// The members by which a model is rough everywhere alike.
std::vector<double*> roughness_of(MaterialModel& model) {
  return std::visit(
      [](auto& m) -> std::vector<double*> {
        using Model = std::decay_t<decltype(m)>;
        if constexpr (std::is_same_v<Model, MetallicRoughness>) return {&m.roughness};
        if constexpr (std::is_same_v<Model, AnisotropicGgx>) return {&m.alpha_x, &m.alpha_y};
        if constexpr (std::is_same_v<Model, Ggx> || std::is_same_v<Model, RoughGlass> ||
                      std::is_same_v<Model, Metal> || std::is_same_v<Model, GgxLambert>)
          return {&m.alpha};
        if constexpr (std::is_same_v<Model, Plastic>)
          if (m.alpha) return {&*m.alpha};
        return {};
      },
      model);
}

// At 1 a root changes nothing.
bool has_roughness_below_one(MaterialModel model) {
  const auto all = roughness_of(model);
  return std::any_of(all.begin(), all.end(), [](const double* alpha) { return *alpha < 1; });
}

void take_roots_of_roughness(Scene& scene) {
  for (auto& material : scene.materials)
    for (double* alpha : roughness_of(material.model)) *alpha = std::sqrt(*alpha);
}

void halve_spots(Scene& scene) {
  for (auto& light : scene.lights)
    if (auto* spot = std::get_if<SpotShape>(&light.shape)) {
      spot->inner_deg /= 2;
      spot->outer_deg /= 2;
    }
}

template <typename Wanted>
bool shows(const Scene& scene, const Wanted& is_wanted) {
  const auto shown = visible_materials(scene);
  return std::any_of(shown.begin(), shown.end(),
                     [&](int material) { return is_wanted(material_at(scene, material)); });
}

std::string reason_unless(bool changes, const char* reason) { return changes ? "" : reason; }

}  // namespace

std::string_view name_of(RenderFault fault) {
  return std::find_if(kRenderFaults.begin(), kRenderFaults.end(),
                      [&](const auto& one) { return one.fault == fault; })
      ->name;
}

std::vector<std::string> render_fault_names() {
  std::vector<std::string> names;
  for (const auto& one : kRenderFaults) names.emplace_back(one.name);
  return names;
}

std::optional<RenderFault> render_fault_named(std::string_view name) {
  for (const auto& one : kRenderFaults)
    if (one.name == name) return one.fault;
  return std::nullopt;
}

std::string why_fault_changes_nothing(const Scene& scene, RenderFault fault) {
  switch (fault) {
    case RenderFault::NormalsByMatrix:
      return std::any_of(scene.instances.begin(), scene.instances.end(),
                         [&](const auto& instance) {
                           return !keeps_angles(instance.matrix) && !mesh_of(scene, instance).normals.empty();
                         })
                 ? ""
                 : "its matrices keep all angles, or its meshes have no vertex normals";
    case RenderFault::RawTextures:
      return std::any_of(scene.textures.begin(), scene.textures.end(),
                         [](const auto& texture) { return image::is_ldr_file(texture.file); })
                 ? ""
                 : "it has no texture of 8 or 16 bits";
    case RenderFault::NoMisWeight:
      return std::any_of(scene.lights.begin(), scene.lights.end(),
                         [](const auto& light) { return has_area(light.shape); })
                 ? ""
                 : "it has no light that both light sampling and BSDF sampling find";
    case RenderFault::EmittersOnly:
      return "";
    case RenderFault::OneBounceLess:
      if (scene.trace_depth == kUnlimitedDepth) return "its trace depth is unlimited";
      return scene.trace_depth == 1 ? "its trace depth is 1: that is emitters-only" : "";
    case RenderFault::EnvironmentQuarterTurn:
    case RenderFault::EnvironmentMirrored:
      return reason_unless(scene.environment.map.has_value(), "it has no environment map");
    case RenderFault::RoughnessNotSquared:
      return reason_unless(shows(scene, [](const Material& m) { return has_roughness_below_one(m.model); }),
                           "it shows no rough surface");
    case RenderFault::SpotFullAngles:
      return reason_unless(
          std::any_of(scene.lights.begin(), scene.lights.end(),
                      [](const auto& light) { return std::holds_alternative<SpotShape>(light.shape); }),
          "it has no spot");
    case RenderFault::LensDiameter:
      return reason_unless(has_lens(scene.camera), "its camera has no lens");
    case RenderFault::NormalMapFlipped:
      return reason_unless(shows(scene, [](const Material& m) { return m.detail.normal_map.has_value(); }),
                           "it shows no normal map");
    case RenderFault::FramesWithoutSign:
      return reason_unless(!materials_in_wrong_frames(scene, FrameSign::None).empty(),
                           "it shows no normal map in a mirrored frame");
    case RenderFault::FramesWithSignOfMesh:
      return reason_unless(!materials_in_wrong_frames(scene, FrameSign::OfMesh).empty(),
                           "no matrix mirrors a normal map");
    case RenderFault::OpacityInverted:
      return reason_unless(shows(scene, [](const Material& m) { return lets_rays_pass(m.detail); }),
                           "all that it shows is opaque");
  }
  return "";
}

Scene with_fault(Scene scene, RenderFault fault) {
  if (fault == RenderFault::NormalsByMatrix) map_normals_by_matrix(scene);
  if (fault == RenderFault::EmittersOnly) scene.trace_depth = 0;
  if (fault == RenderFault::OneBounceLess) --scene.trace_depth;
  if (fault == RenderFault::EnvironmentQuarterTurn) turn_environment(scene, rotation_y(90));
  if (fault == RenderFault::EnvironmentMirrored) turn_environment(scene, scaling({-1, 1, 1}));
  if (fault == RenderFault::RoughnessNotSquared) take_roots_of_roughness(scene);
  if (fault == RenderFault::SpotFullAngles) halve_spots(scene);
  if (fault == RenderFault::LensDiameter) scene.camera.aperture_radius_m /= 2;
  if (fault == RenderFault::FramesWithoutSign)
    scene = with_materials_by_frames(std::move(scene), FrameSign::None);
  if (fault == RenderFault::FramesWithSignOfMesh)
    scene = with_materials_by_frames(std::move(scene), FrameSign::OfMesh);
  return scene;
}

}  // namespace orbs::scene

#include "scene/relations/surface.h"

#include "base/nth.h"
#include "scene/camera_frame.h"
#include "scene/geometry/generators.h"
#include "scene/geometry/world_bounds.h"

#include <utility>

namespace orbs::scene {

std::variant<Scene, std::string> with_clear_box(const Scene& scene) {
  const auto drawn = world_bounds(scene);
  if (!drawn) return "it is empty";
  const auto& camera = scene.camera;
  auto all = joined(*drawn, {camera.position_m, camera.position_m});
  if (camera.end) all = joined(all, {camera.end->position_m, camera.end->position_m});
  Scene out = scene;
  Material clear{"clear", Lambert{}};
  clear.detail.opacity = 0;
  out.materials.push_back(std::move(clear));
  Mesh box = make_cube({0.5});
  box.name = "clear box";
  box.triangle_materials.assign(box.triangles.size(), static_cast<int>(out.materials.size()) - 1);
  out.meshes.push_back(std::move(box));
  // Twice the diameter on each side: lenses and the planes of orthographic cameras lie inside, too.
  const double side = 4 * radius_of(all);
  out.instances.push_back({"clear box",
                           static_cast<int>(out.meshes.size()) - 1,
                           translation((all.low + all.high) * 0.5) * scaling({side, side, side}),
                           {}});
  return out;
}

namespace {

bool can_be_blended(const Material& material) {
  return !std::holds_alternative<Emission>(material.model) && !std::holds_alternative<Blend>(material.model);
}

// The parts of a blend that is there already: indices stay those of the materials before.
void name_parts_themselves(Material& material) {
  if (auto* blend = std::get_if<Blend>(&material.model))
    for (auto& part : blend->parts) part.name += " itself";
}

void shift_materials(Shape& shape, int by) {
  if (shape.material >= 0) shape.material += by;
  if (auto* csg = std::get_if<CsgForm>(&shape.form))
    for (Shape& operand : csg->operands) shift_materials(operand, by);
}

void shift_materials(Scene& scene, int by) {
  for (Mesh& mesh : scene.meshes)
    for (int& material : mesh.triangle_materials) material += by;
  for (Instance& instance : scene.instances)
    for (auto& [from, to] : instance.remap) {
      from += by;
      to += by;
    }
  for (Sphere& sphere : scene.spheres) sphere.material += by;
  for (Shape& shape : scene.shapes) shift_materials(shape, by);
}

}  // namespace

// A blend comes after its parts, so these are before all that was there. What is opened and turned is the
// blend.
std::variant<Scene, std::string> with_blends_of_themselves(const Scene& scene) {
  constexpr double kWeight = 0.25;
  const int count = static_cast<int>(scene.materials.size());
  Scene out = scene;
  out.materials.clear();
  bool is_any = false;
  for (Material part : scene.materials) {
    part.name += " itself";
    part.detail = {};
    name_parts_themselves(part);
    out.materials.push_back(std::move(part));
  }
  for (int i = 0; i < count; ++i) {
    Material& material = out.materials.emplace_back(material_at(scene, i));
    name_parts_themselves(material);
    if (!can_be_blended(material)) continue;
    const Blend::Part itself{material.name + " itself", i};
    material.model = Blend{{itself, itself}, kWeight, {}};
    is_any = is_any || visible_materials(scene).contains(i);
  }
  if (!is_any) return "it shows nothing that can be a part of a blend";
  shift_materials(out, count);
  return out;
}

namespace {

void look_up_at_second(Material& material) {
  std::visit(
      [](auto& model) {
        if constexpr (requires { model.texture; })
          if (model.texture) model.texture->uv_set = 1;
      },
      material.model);
  SurfaceDetail& detail = material.detail;
  if (detail.opacity_texture) detail.opacity_texture->uv_set = 1;
  if (detail.normal_map) detail.normal_map->texture.uv_set = 1;
  if (detail.bump_map) detail.bump_map->texture.uv_set = 1;
}

}  // namespace

std::variant<Scene, std::string> with_second_coordinates(const Scene& scene) {
  for (const Mesh& mesh : scene.meshes)
    if (!mesh.second_uvs.empty()) return "it has second texture coordinates";
  Scene shapes;  // by their formula have first coordinates alone
  shapes.materials = scene.materials;
  shapes.spheres = scene.spheres;
  shapes.shapes = scene.shapes;
  const auto on_shapes = visible_materials(shapes);
  Scene out = scene;
  bool is_any = false;
  for (const int index : visible_materials(scene)) {
    if (texture_uses(material_at(scene, index)).empty() || on_shapes.contains(index)) continue;
    look_up_at_second(nth(out.materials, index));
    is_any = true;
  }
  if (!is_any) return "no mesh shows a texture";
  for (Mesh& mesh : out.meshes) mesh.second_uvs = mesh.uvs;
  return out;
}

std::variant<Scene, std::string> with_small_lens(const Scene& scene, double share) {
  if (!std::holds_alternative<Perspective>(scene.camera.projection)) return "its camera is no perspective";
  if (has_lens(scene.camera)) return "its camera has a lens";
  Scene out = scene;
  Camera& camera = out.camera;
  if (!camera.focus_distance_m) camera.focus_distance_m = length(camera.look_at_m - camera.position_m);
  camera.aperture_radius_m = share * *camera.focus_distance_m;
  return out;
}

}  // namespace orbs::scene

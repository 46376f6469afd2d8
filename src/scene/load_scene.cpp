#include "scene/load_scene.h"

#include "base/files.h"
#include "scene/load_parts.h"

#include <fmt/format.h>

namespace orbs::scene {

namespace {

Camera load_camera(json::ObjectReader in) {
  constexpr int kLargestSide = 65536;
  Camera camera;
  camera.position_m = in.vec3("position", kPlace);
  camera.look_at_m = in.vec3("look_at", kPlace);
  camera.up = in.vec3_or("up", camera.up, kPlace);
  camera.fov_y_deg = in.number_or("fov_y", camera.fov_y_deg, {1e-3, 179.0});
  camera.width_px = in.integer_or("width", camera.width_px, 1, kLargestSide);
  camera.height_px = in.integer_or("height", camera.height_px, 1, kLargestSide);
  camera.near_m = in.number_or("near", camera.near_m, json::kPositive);
  camera.far_m = in.number_or("far", camera.far_m, json::kPositive);
  if (in.has("focus_distance")) camera.focus_distance_m = in.number("focus_distance", json::kPositive);
  in.finish();
  const Vec3d view = camera.look_at_m - camera.position_m;
  if (length(view) == 0) in.fail("look_at", "must differ from position: the view has no direction");
  // gluLookAt divides by |view x up|: below 1e-9 of their lengths the picture's up direction is rounding
  // noise.
  if (length(cross(view, camera.up)) <= 1e-9 * length(view) * length(camera.up))
    in.fail(in.has("up") ? "up" : "look_at", "up must not be parallel to the view direction");
  return camera;
}

Texture load_texture(json::ObjectReader in, const std::filesystem::path& folder) {
  Texture texture;
  texture.name = in.text("name");
  texture.file = existing_file(in, "file", folder);
  const auto wrap = [&](const char* key) {
    return in.one_of_or(key, "repeat", {"repeat", "clamp"}) == "clamp" ? Wrap::Clamp : Wrap::Repeat;
  };
  texture.wrap_u = wrap("wrap_u");
  texture.wrap_v = wrap("wrap_v");
  in.finish();
  return texture;
}

Scene load_document(const json::Document& document, const std::filesystem::path& folder, SceneBudget left) {
  json::ObjectReader in(document);
  in.one_of("format", {"orbs-scene/1"});
  Scene scene;
  scene.name = in.text("name");
  scene.camera = load_camera(in.object("camera"));
  scene.environment = in.vec3_or("environment", {}, json::kNotNegative);
  Names textures("texture");
  for (auto& entry : in.objects_or_none("textures")) {
    textures.add(entry, "name");
    scene.textures.push_back(load_texture(entry, folder));
  }
  Names materials("material");
  for (auto& entry : in.objects("materials")) {
    materials.add(entry, "name");
    scene.materials.push_back(load_material(entry, textures));
  }
  Names meshes("mesh");
  for (auto& entry : in.objects_or_none("meshes")) {
    meshes.add(entry, "name");
    scene.meshes.push_back(load_mesh(entry, folder, materials, left));
  }
  for (auto& entry : in.objects_or_none("instances"))
    load_instances(entry, meshes, materials, left, scene.instances);
  for (auto& entry : in.objects_or_none("lights")) scene.lights.push_back(load_light(entry, folder));
  if (in.has("integrator")) {
    auto integrator = in.object("integrator");
    scene.trace_depth = integrator.integer_or("trace_depth", scene.trace_depth, 1, 1000);
    integrator.finish();
  }
  in.finish();
  return scene;
}

}  // namespace

Scene load_scene_text(const std::string& name,
                      const std::string& text,
                      const std::filesystem::path& folder,
                      SceneBudget budget) {
  const auto document = json::parse(name, text);
  return load_document(document, folder, budget);
}

Scene load_scene(const std::filesystem::path& file) {
  return load_scene_text(file.string(), read_file(file), std::filesystem::absolute(file).parent_path());
}

int remapped(const Instance& instance, int material) {
  for (const auto& [from, to] : instance.remap)
    if (from == material) return to;
  return material;
}

const std::optional<TextureUse>& texture_of(const MaterialModel& model) {
  static const std::optional<TextureUse> none;
  return std::visit(
      [](const auto& m) -> const std::optional<TextureUse>& {
        if constexpr (requires { m.texture; }) return m.texture;
        return none;
      },
      model);
}

}  // namespace orbs::scene

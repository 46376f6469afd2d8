#include "adapters/obj/obj.h"

#include "adapters/format_limits.h"
#include "adapters/material_meshes.h"
#include "adapters/obj/description.h"
#include "adapters/obj/mtl.h"
#include "adapters/obj/world_parts.h"
#include "base/files.h"
#include "base/nth.h"
#include "scene/geometry/ply.h"

#include <iterator>

#include <fmt/format.h>

namespace orbs::adapters {

namespace {

// `first`: the vertices of the file before those of the part. OBJ counts them from 1, all objects together.
std::string object_text(const obj::WorldPart& part, const std::string& material, std::size_t first) {
  std::string text = fmt::format("o {}\nusemtl {}\n", part.name, material);
  const auto end = std::back_inserter(text);
  for (const Vec3f p : part.mesh.positions) fmt::format_to(end, "v {} {} {}\n", p.x, p.y, p.z);
  for (const Vec2f uv : part.mesh.uvs) fmt::format_to(end, "vt {} {}\n", uv.x, uv.y);
  for (const Vec3f n : part.mesh.normals) fmt::format_to(end, "vn {} {} {}\n", n.x, n.y, n.z);
  for (const auto& triangle : part.mesh.triangles) {
    text += 'f';
    for (const auto corner : triangle) fmt::format_to(end, " {0}/{0}/{0}", first + corner + 1);
    text += '\n';
  }
  return text;
}

}  // namespace

void write_obj(const scene::Scene& scene, const std::filesystem::path& file) {
  const auto stem = file.stem().string();
  const auto names = obj::material_names(scene);
  std::string text = fmt::format(
      "# {}: metres, y up, right-handed. {} has camera, lamps and materials in words.\nmtllib {}.mtl\n",
      comment_text(scene.name), obj::kDescriptionFile, stem);
  std::vector<obj::PartPlace> places;
  std::size_t vertices = 0;
  for (const auto& part : obj::world_parts(scene)) {
    text += object_text(part, nth(names, part.material), vertices);
    vertices += part.mesh.positions.size();
    places.push_back({"object", part.name, part.material});
  }
  write_file(file, text);
  write_file(file.parent_path() / (stem + ".mtl"), obj::mtl_text(scene, names, stem));
  obj::write_description(scene, places, stem, file.parent_path());
}

void write_ply_parts(const scene::Scene& scene, const std::filesystem::path& file) {
  const std::string stem = "scene";
  std::vector<obj::PartPlace> places;
  for (const auto& part : obj::world_parts(scene)) {
    const auto name = fmt::format("{}-{}.ply", stem, part.name);
    scene::write_ply(part.mesh, file.parent_path() / name, scene::PlyContent::Common);
    places.push_back({"file", name, part.material});
  }
  obj::write_description(scene, places, stem, file.parent_path());
}

std::vector<std::string> obj_limits(const scene::Scene& scene) {
  std::vector<std::string> reasons = beyond_orbs_limits(
      scene, "files of meshes",
      {{"C1", "C2", "C3", "C4", "D1", "D2", "D3", "D4", "D5", "D6", "N1", "N2", "N3", "N4", "N5", "N6"},
       {{"V1", "files of meshes say nothing of layers"}}});
  for (const int index : scene::visible_materials(scene))
    for (auto& reason : {obj::material_limit(material_at(scene, index)),
                         uv_set_limit(scene, index, "a mesh in these files")})
      if (!reason.empty()) reasons.push_back(reason);
  return reasons;
}

Exporter obj_exporter() {
  return {.format = "obj",
          .scene_file = "scene.obj",
          .settings = {},
          .limits = [](const scene::Scene& scene, const SceneSettings&) { return obj_limits(scene); },
          .write = [](const scene::Scene& scene, const SceneSettings&,
                      const std::filesystem::path& file) { write_obj(scene, file); }};
}

Exporter ply_exporter() {
  return {.format = "ply",
          .scene_file = obj::kDescriptionFile,
          .settings = {},
          .limits = [](const scene::Scene& scene, const SceneSettings&) { return obj_limits(scene); },
          .write = [](const scene::Scene& scene, const SceneSettings&,
                      const std::filesystem::path& file) { write_ply_parts(scene, file); }};
}

}  // namespace orbs::adapters

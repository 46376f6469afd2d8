#include "run/plan/scene_hash.h"

#include "base/files.h"

namespace orbs::run {

std::uint64_t scene_content_hash(const scene::Scene& scene, const std::filesystem::path& file) {
  auto hash = content_hash(read_file(file));
  if (!scene.notes.camera.empty()) hash = content_hash(scene.notes.camera, hash);
  const auto add = [&](const auto& values) {
    hash =
        content_hash({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0])}, hash);
  };
  for (const auto& mesh : scene.meshes) {
    add(mesh.positions);
    add(mesh.normals);
    add(mesh.tangents);
    add(mesh.uvs);
    add(mesh.triangles);
    add(mesh.triangle_materials);
  }
  for (const auto& texture : scene.textures) hash = content_hash(read_file(texture.file), hash);
  for (const auto& light : scene.lights)
    if (light.ies) hash = content_hash(read_file(light.ies->file), hash);
  for (const auto& table : scene.notes.tables) hash = content_hash(read_file(table), hash);
  return hash;
}

}  // namespace orbs::run

#include "adapters/hydra/vsgf.h"

#include "adapters/hydra/binary.h"

#include <cstdint>
#include <vector>

namespace orbs::adapters::hydra {

namespace {

constexpr std::uint32_t kHasTangents = 1;
constexpr std::size_t kHeader_bytes = 24;

// Four floats for each vector; the last is 1 for points.
void append_vectors(std::string& bytes, const std::vector<Vec3f>& vectors, float last) {
  for (const Vec3f v : vectors)
    for (const float number : {v.x, v.y, v.z, last}) append_bytes(bytes, number);
}

}  // namespace

// HydraCore3 computes no normals: without them it ends with an assertion of Embree. So they are always
// written; tangents may be zero. The number of materials is not read.
std::string vsgf_bytes(const scene::Mesh& mesh, int first_material) {
  std::string body;
  append_vectors(body, mesh.positions, 1);
  append_vectors(body, mesh.normals, 0);
  append_vectors(body, mesh.tangents, 0);
  for (const Vec2f uv : mesh.uvs)
    for (const float number : {uv.x, uv.y}) append_bytes(body, number);
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t corner : triangle) append_bytes(body, corner);
  for (const int material : mesh.triangle_materials)
    append_bytes(body, static_cast<std::uint32_t>(first_material + material));
  std::string bytes;
  append_bytes(bytes, static_cast<std::uint64_t>(kHeader_bytes + body.size()));
  append_bytes(bytes, vertex_count(mesh));
  append_bytes(bytes, static_cast<std::uint32_t>(3 * mesh.triangles.size()));
  append_bytes(bytes, static_cast<std::uint32_t>(mesh.triangle_materials.size()));
  append_bytes(bytes, kHasTangents);
  return bytes + body;
}

}  // namespace orbs::adapters::hydra

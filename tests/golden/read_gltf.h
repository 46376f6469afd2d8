#pragma once

#include "base/matrix.h"
#include "golden/read_back.h"
#include "scene/scene.h"

#include <array>
#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

/// A small reader of .glb files, written from the specification and not from the exporter.
namespace orbs::tests {

struct GltfFile {
  nlohmann::json json;
  std::string binary;
};

/// Throws std::runtime_error when header and chunks are not as section 4 of the specification has them.
GltfFile read_glb(const std::filesystem::path& file);

/// Arrays of an accessor. Throws std::runtime_error when it does not lie within its view and the buffer, is
/// not aligned, or has another type.
std::vector<Vec3f> read_vec3(const GltfFile& file, int accessor);
std::vector<std::array<float, 4>> read_vec4(const GltfFile& file, int accessor);
std::vector<Vec2f> read_vec2(const GltfFile& file, int accessor);
std::vector<std::uint32_t> read_indices(const GltfFile& file, int accessor);

/// The bytes of a view.
std::string read_view(const GltfFile& file, int view);

/// The one primitive of a mesh: uvs as in the file, or zero where it has none; no materials.
scene::Mesh read_mesh(const GltfFile& file, int mesh);

/// The matrix of a node.
Mat4 node_matrix(const nlohmann::json& node);

/// Coordinates of the file as the texture of the textureInfo sees them, v from the bottom.
Vec2f seen_uv(const nlohmann::json& info, Vec2f uv);

/// The reflectance of a material without transmission at a cosine, but for its diffuse part, by appendix B of
/// the specification and the extensions KHR_materials_specular and _ior.
double reflectance(const nlohmann::json& material, double cosine);

}  // namespace orbs::tests

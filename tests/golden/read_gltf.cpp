#include "golden/read_gltf.h"

#include "base/files.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace orbs::tests {

namespace {

using Json = nlohmann::json;

void demand(bool is_so, const std::string& what) {
  if (!is_so) throw std::runtime_error(what);
}

std::uint32_t number_at(const std::string& bytes, std::size_t offset) {
  demand(offset + 4 <= bytes.size(), "the file ends too early");
  std::uint32_t number = 0;
  std::memcpy(&number, bytes.data() + offset, 4);
  return number;
}

template <typename Element>
std::vector<Element> elements(const GltfFile& file, int accessor, const char* type, int component) {
  const Json& a = file.json.at("accessors").at(static_cast<std::size_t>(accessor));
  demand(a.at("type") == type && a.at("componentType") == component, "another type of accessor");
  const std::string bytes = read_view(file, a.at("bufferView"));
  const std::size_t count = a.at("count");
  demand(count > 0 && count * sizeof(Element) == bytes.size(), "the view is not as long as its elements");
  std::vector<Element> out(count);
  std::memcpy(out.data(), bytes.data(), bytes.size());
  return out;
}

Vec3d vec3(const Json& numbers) { return {numbers.at(0), numbers.at(1), numbers.at(2)}; }

}  // namespace

GltfFile read_glb(const std::filesystem::path& path) {
  const std::string bytes = read_file(path);
  demand(bytes.starts_with("glTF") && number_at(bytes, 4) == 2, "no glTF 2 in a .glb");
  demand(number_at(bytes, 8) == bytes.size(), "the length of the header is not that of the file");
  const std::size_t length = number_at(bytes, 12);
  demand(length % 4 == 0 && bytes.substr(16, 4) == "JSON" && 20 + length <= bytes.size(), "no chunk of JSON");
  GltfFile file{Json::parse(bytes.substr(20, length)), {}};
  const std::size_t second = 20 + length;
  if (second == bytes.size()) return file;
  const std::size_t binary = number_at(bytes, second);
  demand(binary % 4 == 0 && bytes.substr(second + 4, 4) == std::string("BIN\0", 4),
         "no chunk of binary data");
  demand(second + 8 + binary == bytes.size(), "more than two chunks");
  file.binary = bytes.substr(second + 8);
  const std::size_t stated = file.json.at("buffers").at(0).at("byteLength");
  demand(stated <= binary && binary < stated + 4, "the buffer is not as long as its chunk");
  return file;
}

std::string read_view(const GltfFile& file, int view) {
  const Json& v = file.json.at("bufferViews").at(static_cast<std::size_t>(view));
  const std::size_t offset = v.at("byteOffset");
  const std::size_t length = v.at("byteLength");
  demand(v.at("buffer") == 0 && offset % 4 == 0, "the view is not aligned");
  demand(offset + length <= file.json.at("buffers").at(0).at("byteLength"), "the view leaves the buffer");
  return file.binary.substr(offset, length);
}

std::vector<Vec3f> read_vec3(const GltfFile& file, int accessor) {
  return elements<Vec3f>(file, accessor, "VEC3", 5126);
}

std::vector<std::array<float, 4>> read_vec4(const GltfFile& file, int accessor) {
  return elements<std::array<float, 4>>(file, accessor, "VEC4", 5126);
}

std::vector<Vec2f> read_vec2(const GltfFile& file, int accessor) {
  return elements<Vec2f>(file, accessor, "VEC2", 5126);
}

std::vector<std::uint32_t> read_indices(const GltfFile& file, int accessor) {
  return elements<std::uint32_t>(file, accessor, "SCALAR", 5125);
}

scene::Mesh read_mesh(const GltfFile& file, int index) {
  const Json& primitive = file.json.at("meshes").at(static_cast<std::size_t>(index)).at("primitives").at(0);
  const Json& attributes = primitive.at("attributes");
  scene::Mesh mesh;
  mesh.positions = read_vec3(file, attributes.at("POSITION"));
  mesh.normals = read_vec3(file, attributes.at("NORMAL"));
  mesh.uvs.resize(mesh.positions.size());
  if (attributes.contains("TEXCOORD_0")) mesh.uvs = read_vec2(file, attributes.at("TEXCOORD_0"));
  demand(mesh.normals.size() == mesh.positions.size() && mesh.uvs.size() == mesh.positions.size(),
         "attributes of different lengths");
  const auto corners = read_indices(file, primitive.at("indices"));
  demand(corners.size() % 3 == 0, "no whole triangles");
  for (std::size_t i = 0; i < corners.size(); i += 3)
    mesh.triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
  for (const auto corner : corners) demand(corner < mesh.positions.size(), "a corner that is not there");
  return mesh;
}

Mat4 node_matrix(const Json& node) {
  const Vec3d t = node.contains("translation") ? vec3(node.at("translation")) : Vec3d{};
  const Vec3d s = node.contains("scale") ? vec3(node.at("scale")) : Vec3d{1, 1, 1};
  const std::array<double, 4> q = node.contains("rotation") ? node.at("rotation").get<std::array<double, 4>>()
                                                            : std::array{0., 0., 0., 1.};
  const auto [x, y, z, w] = q;
  demand(std::abs(x * x + y * y + z * z + w * w - 1) < 1e-12, "no unit quaternion");
  const Mat4 rotation{{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w), 0,  //
                       2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w), 0,  //
                       2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y), 0,  //
                       0, 0, 0, 1}};
  return translation(t) * rotation * scaling(s);
}

Vec2f seen_uv(const Json& info, Vec2f uv) {
  double u = static_cast<double>(uv.x);
  double v = static_cast<double>(uv.y);
  if (info.contains("extensions")) {
    const Json& transform = info.at("extensions").at("KHR_texture_transform");
    const double s = transform.at("scale").at(0);
    const double t = transform.at("scale").at(1);
    const double angle = transform.at("rotation");
    const double moved_u = std::cos(angle) * s * u + std::sin(angle) * t * v;
    const double moved_v = -std::sin(angle) * s * u + std::cos(angle) * t * v;
    u = moved_u + transform.at("offset").at(0).get<double>();
    v = moved_v + transform.at("offset").at(1).get<double>();
  }
  return {static_cast<float>(u), static_cast<float>(1 - v)};
}

double reflectance(const Json& material, double cosine) {
  const Json extensions = material.value("extensions", Json::object());
  const auto number = [&](const char* extension, const char* key, double otherwise) {
    return extensions.contains(extension) ? extensions.at(extension).value(key, otherwise) : otherwise;
  };
  const Json& base = material.at("pbrMetallicRoughness");
  const double metallic = base.at("metallicFactor");
  const double specular = number("KHR_materials_specular", "specularFactor", 1);
  const double ior = number("KHR_materials_ior", "ior", 1.5);
  const double of_index = std::pow((ior - 1) / (ior + 1), 2);
  const double schlick = std::pow(1 - cosine, 5);
  const double f0 = base.at("baseColorFactor").at(0);
  const double metal = f0 + (1 - f0) * schlick;
  const double dielectric = specular * (of_index + (1 - of_index) * schlick);
  return metallic * metal + (1 - metallic) * dielectric;
}

}  // namespace orbs::tests

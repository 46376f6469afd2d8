#include "unit/importer/made_gltf.h"

#include "adapters/gltf/glb.h"
#include "base/error.h"
#include "image/image_io.h"

#include <algorithm>
#include <cstring>

#include <gtest/gtest.h>

namespace orbs::importer_tests {

using nlohmann::json;

int MadeGltf::add(const char* list, const nlohmann::json& entry) {
  json[list].push_back(entry);
  return static_cast<int>(json[list].size()) - 1;
}

int MadeGltf::add_view(const std::string& bytes) {
  buffer.resize((buffer.size() + 3) / 4 * 4, '\0');
  const int view =
      add("bufferViews", {{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", bytes.size()}});
  buffer += bytes;
  return view;
}

namespace {

template <typename Number>
std::string bytes_of(const std::vector<Number>& numbers) {
  std::string bytes(numbers.size() * sizeof(Number), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

}  // namespace

int MadeGltf::add_floats(const std::vector<float>& numbers, const std::string& type) {
  const std::size_t width = type == "SCALAR" ? 1
                            : type == "MAT4" ? 16
                                             : static_cast<std::size_t>(type.back() - '0');
  const int view = add_view(bytes_of(numbers));
  return add(
      "accessors",
      {{"bufferView", view}, {"componentType", 5126}, {"count", numbers.size() / width}, {"type", type}});
}

int MadeGltf::add_indices(const std::vector<std::uint16_t>& indices) {
  const int view = add_view(bytes_of(indices));
  return add("accessors",
             {{"bufferView", view}, {"componentType", 5123}, {"count", indices.size()}, {"type", "SCALAR"}});
}

int MadeGltf::add_image(const std::vector<std::array<int, 3>>& texels) {
  auto image = image::make_image(static_cast<int>(texels.size()), 1, {"R", "G", "B"});
  for (std::size_t i = 0; i < texels.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) image.pixels[3 * i + c] = static_cast<float>(texels[i].at(c)) / 255;
  return add("images", {{"bufferView", add_view(image::png_bytes(image))}, {"mimeType", "image/png"}});
}

std::string MadeGltf::glb() const {
  auto whole = json;
  if (!buffer.empty()) whole["buffers"] = json::array({{{"byteLength", buffer.size()}}});
  return adapters::gltf::glb(whole.dump(), buffer);
}

MadeGltf triangle() {
  MadeGltf made;
  const int positions = made.add_floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
  const int normals = made.add_floats({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
  const int uvs = made.add_floats({0, 1, 1, 1, 0, 0}, "VEC2");
  const int indices = made.add_indices({0, 1, 2});
  made.add("materials", {{"name", "paint"}, {"doubleSided", true}});
  made.add(
      "meshes",
      {{"name", "sheet"},
       {"primitives",
        json::array({{{"attributes", {{"POSITION", positions}, {"NORMAL", normals}, {"TEXCOORD_0", uvs}}},
                      {"indices", indices},
                      {"material", 0}}})}});
  made.add("nodes", {{"name", "here"}, {"mesh", 0}});
  made.add("scenes", {{"nodes", {0}}});
  made.json["scene"] = 0;
  return made;
}

MadeGltf with_material(const nlohmann::json& material) {
  auto made = triangle();
  const int image = made.add_image({{255, 0, 0}, {0, 0, 255}});
  made.add("textures", {{"source", image}});
  made.json["materials"][0].update(material);
  return made;
}

bool Imported::names(const std::string& what) const {
  const auto remarks = report.remarks();
  return std::any_of(remarks.begin(), remarks.end(),
                     [&](const auto& remark) { return remark.what.starts_with(what); });
}

Imported ImportFolder::import(const MadeGltf& made, const importer::View& view) const {
  write_file(path() / "scene.glb", made.glb());
  const auto folder = path() / "made";
  remove_tree(folder);
  make_folder(folder);
  Imported imported;
  imported.scene = importer::import_scene(path() / "scene.glb", folder, "made", view, imported.report);
  return imported;
}

std::string ImportFolder::refusal(const std::string& bytes, const std::string& name) const {
  write_file(path() / name, bytes);
  const auto folder = path() / "made";
  remove_tree(folder);
  make_folder(folder);
  importer::Report report;
  try {
    importer::import_scene(path() / name, folder, "made", {}, report);
  } catch (const InputError& e) {
    return e.what();
  }
  ADD_FAILURE() << "the file was read";
  return "";
}

}  // namespace orbs::importer_tests

// Files that are torn, wrong or hostile: each is refused with a word, and none does harm.
#include "unit/importer/made_gltf.h"

#include <limits>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace {

using namespace orbs;
using importer_tests::ImportFolder;
using importer_tests::MadeGltf;
using importer_tests::triangle;
using nlohmann::json;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

void expect_refused(const MadeGltf& made, const std::string& because) {
  const ImportFolder folder;
  const auto message = folder.refusal(made);
  EXPECT_TRUE(contains(message, because)) << message;
  EXPECT_TRUE(contains(message, "scene.glb")) << message;
}

// Of the header each, of the rest some.
TEST(BadGltf, APartOfAFileIsRefused) {
  const ImportFolder folder;
  const auto whole = triangle().glb();
  for (std::size_t size = 0; size < whole.size(); size += size < 40 ? 1 : 13)
    EXPECT_NE(folder.refusal(whole.substr(0, size)), "") << size << " of " << whole.size();
}

// Whatever one wrong bit makes of it, it is read or refused.
TEST(BadGltf, NoFlippedBitDoesHarm) {
  const ImportFolder folder;
  const auto whole = triangle().glb();
  for (std::size_t bit = 0; bit < 8 * whole.size(); bit += 31) {
    auto bytes = whole;
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << bit % 8));
    write_file(folder.path() / "flipped.glb", bytes);
    const auto made = folder.path() / "flipped";
    make_folder(made);
    importer::Report report;
    try {
      importer::import_scene(folder.path() / "flipped.glb", made, "flipped", {}, report);
    } catch (const InputError&) {
    }
    remove_tree(made);
  }
}

TEST(BadGltf, WhatIsNoGltfIsRefused) {
  const ImportFolder folder;
  EXPECT_TRUE(contains(folder.refusal("solid cube\n", "scene.gltf"), "scene.gltf:1:1"))
      << folder.refusal("x", "scene.gltf");
  EXPECT_TRUE(contains(folder.refusal("[]", "scene.gltf"), "must be an object, is array"));
  EXPECT_TRUE(contains(folder.refusal("{}", "scene.gltf"), "asset"));
  EXPECT_TRUE(
      contains(folder.refusal(R"({"asset": {"version": "1.0"}})", "scene.gltf"), "is '1.0'; 2.0 is read"));
  EXPECT_TRUE(contains(folder.refusal(std::string("glTF\1\0\0\0\x14\0\0\0\0\0\0\0JSON", 20)),
                       "has version 1 of glTF"));
}

TEST(BadGltf, DeepNestingIsRefused) {
  auto made = triangle();
  json deep = 1;
  for (int i = 0; i < 200; ++i) deep = json::array({deep});
  made.json["extras"] = deep;
  expect_refused(made, "64");
}

TEST(BadGltf, IndicesThatLeadNowhereAreNamed) {
  const auto broken = [](const char* pointer, const json& value) {
    auto made =
        importer_tests::with_material({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    made.json[json::json_pointer(pointer)] = value;
    return made;
  };
  expect_refused(broken("/meshes/0/primitives/0/attributes/POSITION", 40),
                 "accessor 40, and the file has 4 of them");
  expect_refused(broken("/meshes/0/primitives/0/material", 7), "material 7, and the file has 1");
  expect_refused(broken("/nodes/0/mesh", 3), "mesh 3, and the file has 1");
  expect_refused(broken("/nodes/0/children", {9}), "node 9, and the file has 1");
  expect_refused(broken("/nodes/0/camera", 2), "camera 2, and the file has 0");
  expect_refused(broken("/nodes/0/skin", 2), "skin 2, and the file has 0");
  expect_refused(broken("/scene", 5), "scene 5, and the file has 1");
  expect_refused(broken("/scenes/0/nodes", {-4}), "/scenes/0/nodes/0");
  expect_refused(broken("/accessors/0/bufferView", 40), "buffer view 40, and the file has 5");
  expect_refused(broken("/bufferViews/0/buffer", 2), "/bufferViews/0/buffer");
  expect_refused(broken("/images/0/bufferView", 17), "/images/0/bufferView");
  expect_refused(broken("/textures/0/source", 8), "image 8, and the file has 1");
  expect_refused(broken("/textures/0/sampler", 8), "sampler 8, and the file has 0");
  expect_refused(broken("/materials/0/pbrMetallicRoughness/baseColorTexture/index", 8),
                 "texture 8, and the file has 1");
  expect_refused(broken("/nodes/0/extensions/KHR_lights_punctual/light", 6), "light 6, and the file has 0");
}

TEST(BadGltf, AVertexThatIsNotThereIsNamed) {
  auto made = triangle();
  made.json["meshes"][0]["primitives"][0]["indices"] = made.add_indices({0, 1, 3});
  expect_refused(made, "the indices of mesh 'sheet': the one at place 2 is 3, and there are 3 vertices");
}

TEST(BadGltf, PlacesThatAreNoNumbersAreNamed) {
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e20F}) {
    auto made = triangle();
    made.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"] =
        made.add_floats({0, 0, 0, 1, 0, 0, 0, bad, 0}, "VEC3");
    expect_refused(made, "POSITION of mesh 'sheet': vertex 2");
  }
}

TEST(BadGltf, NodesThatAreNoTreeAreNamed) {
  auto loop = triangle();
  loop.json["nodes"][0]["children"] = {0};
  expect_refused(loop, "node 'here' is reached twice");
  auto two_parents = triangle();
  two_parents.json["nodes"][0]["children"] = {1, 2};
  two_parents.add("nodes", {{"children", {2}}});
  two_parents.add("nodes", {{"name", "child"}});
  expect_refused(two_parents, "node 'child' is reached twice");
}

TEST(BadGltf, SizesBeyondTheFileAreNamed) {
  auto count = triangle();
  count.json["accessors"][0]["count"] = 1 << 25;
  expect_refused(count, "POSITION of mesh 'sheet' has 33554432 elements, which end at byte");
  auto zeros = triangle();
  zeros.json["accessors"][0] = {{"componentType", 5126}, {"count", 1 << 25}, {"type", "VEC3"}};
  expect_refused(zeros, "at most 4194304 are read");
  auto view = triangle();
  view.json["bufferViews"][0]["byteLength"] = 1 << 30;
  expect_refused(view, "/bufferViews/0/byteLength");
  auto offset = triangle();
  offset.json["accessors"][0]["byteOffset"] = 2147483647;
  expect_refused(offset, "end at byte 2147483647");
  auto stride = triangle();
  stride.json["bufferViews"][0]["byteStride"] = 252;
  expect_refused(stride, "end at byte 516");
}

TEST(BadGltf, AttributesOfOtherLengthsAreNamed) {
  auto made = triangle();
  made.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = made.add_floats({0, 0, 1}, "VEC3");
  expect_refused(made, "NORMAL of mesh 'sheet' has 1 elements, and there are 3 positions");
  auto width = triangle();
  width.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = 2;
  expect_refused(width, "POSITION of mesh 'sheet' has elements of 2 numbers; 3 were expected");
}

TEST(BadGltf, FilesOutsideOfTheFolderAreNotRead) {
  const ImportFolder folder;
  write_file(folder.path().parent_path() / "orbs-importer-outside.bin", "x");
  std::filesystem::create_symlink("/etc/hostname", folder.path() / "link.png");
  std::filesystem::create_symlink("/etc", folder.path() / "link");
  ASSERT_FALSE(std::filesystem::current_path() == folder.path());
  const std::vector<std::pair<const char*, const char*>> cases{
      {"../orbs-importer-outside.bin", "leads out of the folder"},
      {"%2e%2e/orbs-importer-outside.bin", "leads out of the folder"},
      {"/etc/hostname", "leads out of the folder"},
      {"http://example.com/a.png", "nothing is fetched"},
      {"file:///etc/hostname", "nothing is fetched"},
      {"%2fetc%2fhostname", "leads out of the folder"},
      {"below/../../orbs-importer-outside.bin", "leads out of the folder"},
      {"~/.profile", "there is no such file in"},
      {"$HOME/.profile", "there is no such file in"},
      {"link.png", "symbolic links are not followed"},
      {"link/hostname", "symbolic links are not followed"},
      {"nowhere.png", "there is no such file in"}};
  for (const auto& [uri, because] : cases) {
    auto image =
        importer_tests::with_material({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    image.json["images"][0] = {{"uri", uri}};
    auto message = folder.refusal(image);
    EXPECT_TRUE(contains(message, because)) << uri << ": " << message;
    auto buffer = triangle().json;
    buffer["buffers"] = json::array({{{"byteLength", 1}, {"uri", uri}}});
    buffer.erase("bufferViews");
    message = folder.refusal(buffer.dump(), "scene.gltf");
    EXPECT_TRUE(contains(message, because)) << uri << ": " << message;
  }
  std::filesystem::remove(folder.path().parent_path() / "orbs-importer-outside.bin");
}

// The same functions of the library open what may be opened.
TEST(BadGltf, ABufferBesideTheFileIsRead) {
  const ImportFolder folder;
  auto made = triangle();
  made.json["buffers"] =
      json::array({{{"byteLength", made.buffer.size()}, {"uri", "below/the%20numbers.bin"}}});
  make_folder(folder.path() / "below");
  write_file(folder.path() / "below" / "the numbers.bin", made.buffer);
  write_file(folder.path() / "beside.gltf", made.json.dump());
  const auto out = folder.path() / "out";
  make_folder(out);
  importer::Report report;
  const auto scene = importer::import_scene(folder.path() / "beside.gltf", out, "beside", {}, report);
  EXPECT_EQ(scene.meshes.size(), 1u);
}

TEST(BadGltf, AnImageThatIsTornIsNamed) {
  auto made =
      importer_tests::with_material({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
  made.json["images"][0] = {
      {"bufferView", made.add_view("\x89PNG\r\n\x1a\nwhat")}, {"mimeType", "image/png"}, {"name", "wood"}};
  expect_refused(made, "image 'wood' cannot be read");
}

TEST(BadGltf, PackedMeshesAreRefused) {
  auto required = triangle();
  required.json["extensionsRequired"] = {"EXT_meshopt_compression"};
  expect_refused(required, "packed with EXT_meshopt_compression, which is not read");
  expect_refused(required, "'npx @gltf-transform/cli copy PACKED.glb PLAIN.glb'");
  auto fallback = triangle().json;
  fallback["buffers"] = json::array(
      {{{"byteLength", 36}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}});
  const ImportFolder folder;
  const auto message = folder.refusal(fallback.dump(), "scene.gltf");
  EXPECT_TRUE(contains(message, "/buffers/0: stands for meshes that are packed with EXT_meshopt")) << message;
  auto used = triangle();
  used.json["accessors"][0].erase("bufferView");
  used.json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 0}};
  expect_refused(used, "the triangles of mesh 'sheet' are packed with KHR_draco_mesh_compression");
}

TEST(BadGltf, ASceneThatShowsNothingSaysWhatWasLeftOut) {
  auto made = triangle();
  made.json["meshes"][0]["primitives"][0]["mode"] = 1;
  expect_refused(made, "points and lines: 1 (mesh 'sheet'): nothing");
}

TEST(BadGltf, LightsAndCamerasWithoutSenseAreNamed) {
  auto camera = triangle();
  camera.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 4}, {"znear", 0.1}}}});
  camera.json["nodes"][0]["camera"] = 0;
  expect_refused(camera, "field of view");
  auto light = triangle();
  light.json["extensions"]["KHR_lights_punctual"]["lights"] =
      json::array({{{"type", "point"}, {"intensity", -1}}});
  light.json["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0;
  expect_refused(light, "expected none below 0");
  auto turned = triangle();
  turned.json["nodes"][0]["rotation"] = {0, 0, 0, 0};
  expect_refused(turned, "quaternion without a length");
}

}  // namespace

// Normal maps and second coordinates in what the exporter to glTF writes, read by the words of glTF's
// specification.
#include "adapters/gltf/gltf.h"
#include "base/files.h"
#include "golden/read_gltf.h"
#include "golden/written_gltf.h"
#include "image/image_io.h"
#include "scene/geometry/generators.h"
#include "scene/load/load_scene.h"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using nlohmann::json;
namespace fs = std::filesystem;

const fs::path kCases = fs::path(ORBS_SOURCE_DIR) / "data/cases/everyday";

class GltfDetail : public tests::WrittenGltf {
 protected:
  // The first texel of the file's one image, as it is stored.
  Vec3d first_texel(const tests::GltfFile& file) const {
    write_file(folder_ / "map.png", tests::read_view(file, file.json.at("images").at(0).at("bufferView")));
    const auto image = image::read_image(folder_ / "map.png");
    return {double{image.at(0, 0, 0)}, double{image.at(0, 0, 1)}, double{image.at(0, 0, 2)}};
  }
};

const json& attributes_of(const tests::GltfFile& file, std::size_t mesh) {
  return file.json.at("meshes").at(mesh).at("primitives").at(0).at("attributes");
}

// 3.7.2.1: the bitangent is cross(normal, tangent) * w. 3.9.3: the texel is 2 c - 1 along tangent, bitangent
// and normal, x and y times the scale. In the mesh, and then where the node puts it.
Vec3d mapped_normal(const tests::GltfFile& file, const json& node, std::size_t vertex, Vec3d texel) {
  const json& attributes = attributes_of(file, node.at("mesh"));
  const auto t = tests::read_vec4(file, attributes.at("TANGENT")).at(vertex);
  const Vec3d tangent{double{t[0]}, double{t[1]}, double{t[2]}};
  EXPECT_NEAR(length(tangent), 1, 1e-6);
  const Vec3d normal = cast<double>(tests::read_vec3(file, attributes.at("NORMAL")).at(vertex));
  const Vec3d bitangent = cross(normal, tangent) * double{t[3]};
  const double scale = file.json.at("materials").at(0).at("normalTexture").value("scale", 1.0);
  const Vec3d c = texel * 2 - Vec3d{1, 1, 1};
  const Vec3d turned = tangent * (scale * c.x) + bitangent * (scale * c.y) + normal * c.z;
  return normalised(transform_direction(tests::node_matrix(node), turned));
}

json surfaces_of_case(const fs::path& folder, const std::string& scene) {
  const json whole = json::parse(read_file(folder / "case.json"));
  for (const json& one : whole.at("scenes"))
    if (one.at("name") == scene) return one.at("analytic").at("surfaces");
  ADD_FAILURE() << "no scene " << scene;
  return json::array();
}

// Plain, with mirrored u, turned, and as an instance that is mirrored.
TEST_F(GltfDetail, NormalsLeanAsTheFormulaOfTheirCaseSays) {
  for (const auto& [folder, name] :
       {std::pair{kCases / "n1_normal_map", "n1-right"}, std::pair{kCases / "n1_normal_map", "n1-below"},
        std::pair{kCases / "n6_second_coordinates", "n6-normals"}}) {
    SCOPED_TRACE(name);
    const auto file = written(scene::load_scene(folder / (std::string(name) + ".json")));
    const json surfaces = surfaces_of_case(folder, name);
    ASSERT_EQ(surfaces.size(), 4U);
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      const json& n = surfaces.at(i).at("shading_normal");
      for (const std::size_t vertex : {0U, 5U}) {
        const Vec3d found = mapped_normal(file, file.json.at("nodes").at(i), vertex, first_texel(file));
        EXPECT_LE(length(found - Vec3d{n.at(0), n.at(1), n.at(2)}), 1e-6) << i;
      }
    }
  }
}

scene::Scene card_with_normal_map() {
  scene::Scene scene;
  scene.camera.position_m = {0, 9, 0};
  scene.camera.up = {0, 0, -1};
  scene.textures = {{"t", fs::path(ORBS_SOURCE_DIR) / "data/common/textures/tilted_normal.png"}};
  scene.textures[0].encoding = scene::Encoding::Linear;
  scene.materials = {{"m", scene::Lambert{{0.5, 0.5, 0.5}, {}}, {1, {}, scene::NormalMap{{0, {}}, 1}, {}}}};
  scene.meshes = {scene::make_plane({1})};
  scene.meshes[0].triangle_materials.assign(2, 0);
  scene.instances = {{"i", 0, {}, {}}};
  return scene;
}

// The specification does not say whether a normal is turned before or after a node stretches it.
TEST_F(GltfDetail, WhatIsStretchedUnlikeIsStretchedInTheFile) {
  auto scene = card_with_normal_map();
  for (const Mat4& place : {scaling({-2, 2, 2}) * rotation_y(30), scaling({2, 1, 1})})
    scene.instances.push_back({"i", 0, translation({0, 3, 0}) * place, {}});
  const auto file = written(scene);
  const json& nodes = file.json.at("nodes");
  EXPECT_EQ(nodes.at(0).at("mesh"), nodes.at(1).at("mesh")) << "turned, enlarged and mirrored alone";
  EXPECT_NE(nodes.at(2).at("mesh"), nodes.at(0).at("mesh"));
  EXPECT_FALSE(nodes.at(2).contains("scale"));
  scene.materials[0].detail = {};
  EXPECT_EQ(written(scene).json.at("meshes").size(), 1U);
}

TEST_F(GltfDetail, SecondCoordinatesAreTheSecondSet) {
  const auto scene = scene::load_scene(kCases / "n6_second_coordinates/n6-glow.json");
  const auto file = written(scene);
  const json& info = file.json.at("materials").at(0).at("emissiveTexture");
  EXPECT_EQ(info.at("texCoord"), 1);
  EXPECT_TRUE(info.at("extensions").contains("KHR_texture_transform"));
  const auto from_the_bottom = [&](const char* set) {
    auto uvs = tests::read_vec2(file, attributes_of(file, 0).at(set));
    for (Vec2f& uv : uvs) uv.y = 1 - uv.y;
    return uvs;
  };
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(from_the_bottom("TEXCOORD_0").at(i).x, scene.meshes[0].uvs[i].x, 1e-6);
    EXPECT_NEAR(from_the_bottom("TEXCOORD_1").at(i).x, scene.meshes[0].second_uvs[i].x, 1e-6);
    EXPECT_NEAR(from_the_bottom("TEXCOORD_1").at(i).y, scene.meshes[0].second_uvs[i].y, 1e-6);
  }
  EXPECT_FALSE(attributes_of(written(card_with_normal_map()), 0).contains("TEXCOORD_1"));
}

TEST_F(GltfDetail, NormalMapsWithoutDirectionsAreRefused) {
  auto scene = card_with_normal_map();
  scene.meshes[0].uvs.assign(4, {0.5F, 0.5F});
  const auto limits = adapters::gltf_limits(scene);
  ASSERT_EQ(limits.size(), 1U);
  EXPECT_NE(limits[0].find("coordinates lie on one line below the normal map of 'm'"), std::string::npos);
}

// Coordinates can take up a shear only where all textures have the same one.
TEST_F(GltfDetail, AShearOfOneTextureAloneIsRefused) {
  auto scene = card_with_normal_map();
  scene.textures.push_back({"colours", fs::path(ORBS_SOURCE_DIR) / "data/common/textures/four_colours.png"});
  auto& texture = std::get<scene::Lambert>(scene.materials[0].model).texture;
  texture = scene::TextureUse{1, scaling({2, 3, 1})};
  const auto file = written(scene);
  const json& material = file.json.at("materials").at(0);
  EXPECT_TRUE(material.at("pbrMetallicRoughness").at("baseColorTexture").contains("extensions"));
  EXPECT_FALSE(material.at("normalTexture").contains("extensions"));
  EXPECT_EQ(material.at("normalTexture").at("index"), 1);
  texture->matrix(0, 1) = 1;
  const auto limits = adapters::gltf_limits(scene);
  ASSERT_EQ(limits.size(), 1U);
  EXPECT_EQ(limits[0], "material 'm' has textures with different matrices");
}

}  // namespace

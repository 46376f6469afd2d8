// What of a file is understood, and what is named because it is not.
#include "image/image_io.h"
#include "scene/camera_frame.h"
#include "unit/image/png_bytes.h"
#include "unit/importer/made_gltf.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using importer_tests::ImportFolder;
using importer_tests::MadeGltf;
using importer_tests::triangle;
using importer_tests::with_material;
using nlohmann::json;

const scene::MaterialModel& only_model(const scene::Scene& scene) {
  EXPECT_EQ(scene.materials.size(), 1u);
  return scene.materials.at(0).model;
}

TEST(ImportedMesh, IsTheTriangleOfTheFileWithVFromTheBottom) {
  const auto [scene, report] = ImportFolder().import(triangle());
  ASSERT_EQ(scene.meshes.size(), 1u);
  const auto& mesh = scene.meshes[0];
  EXPECT_EQ(mesh.name, "sheet");
  EXPECT_EQ(mesh.positions, (std::vector<Vec3f>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(mesh.uvs, (std::vector<Vec2f>{{0, 0}, {1, 0}, {0, 1}}));
  EXPECT_EQ(mesh.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}}));
  EXPECT_TRUE(report.remarks().empty()) << text_of(report.remarks().front());
}

TEST(ImportedMesh, WithoutNormalsIsFlat) {
  auto made = triangle();
  made.json["meshes"][0]["primitives"][0]["attributes"].erase("NORMAL");
  const auto mesh = ImportFolder().import(made).scene.meshes.at(0);
  EXPECT_EQ(mesh.normals, std::vector<Vec3f>(3, {0, 0, 1}));
}

TEST(ImportedMesh, NormalsWithoutADirectionAreMendedAndNamed) {
  auto made = triangle();
  made.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] =
      made.add_floats({0, 0, 1, 0, 0, 0, 0, 0, 1}, "VEC3");
  const auto imported = ImportFolder().import(made);
  EXPECT_EQ(imported.scene.meshes.at(0).normals, std::vector<Vec3f>(3, {0, 0, 1}));
  EXPECT_TRUE(imported.names("normals of length 0"));
}

TEST(ImportedMesh, StripsAndFansAreTriangles) {
  const auto triangles = [](int mode) {
    auto made = triangle();
    auto& primitive = made.json["meshes"][0]["primitives"][0];
    primitive["mode"] = mode;
    primitive["attributes"] = {{"POSITION", made.add_floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, "VEC3")},
                               {"NORMAL", made.add_floats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3")}};
    primitive["indices"] = made.add_indices({0, 1, 2, 3});
    return ImportFolder().import(made).scene.meshes.at(0).triangles;
  };
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;
  EXPECT_EQ(triangles(5), (Triangles{{0, 1, 2}, {1, 3, 2}}));
  EXPECT_EQ(triangles(6), (Triangles{{1, 2, 0}, {2, 3, 0}}));
}

TEST(ImportedMesh, NormalisedAndInterleavedNumbersAreRead) {
  auto made = triangle();
  // Bytes: two of a coordinate, two that are skipped.
  const std::string bytes{"\x00\xff\x01\x01\xff\xff\x01\x01\x00\x00\x01\x01", 12};
  const int view = made.add_view(bytes);
  made.json["bufferViews"][static_cast<std::size_t>(view)]["byteStride"] = 4;
  made.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = made.add(
      "accessors",
      {{"bufferView", view}, {"componentType", 5121}, {"normalized", true}, {"count", 3}, {"type", "VEC2"}});
  EXPECT_EQ(ImportFolder().import(made).scene.meshes.at(0).uvs, (std::vector<Vec2f>{{0, 0}, {1, 0}, {0, 1}}));
}

TEST(ImportedMesh, SparseAccessorsReplaceElements) {
  auto made = triangle();
  const int place = made.add_view(std::string("\x02\x00", 2));
  const int value =
      made.json["accessors"][static_cast<std::size_t>(made.add_floats({5, 6, 7}, "VEC3"))]["bufferView"];
  made.json["accessors"][0]["sparse"] = {{"count", 1},
                                         {"indices", {{"bufferView", place}, {"componentType", 5123}}},
                                         {"values", {{"bufferView", value}}}};
  EXPECT_EQ(ImportFolder().import(made).scene.meshes.at(0).positions.at(2), (Vec3f{5, 6, 7}));
}

TEST(ImportedMesh, ColoursOfVerticesThatAreAllAlikeTintTheMaterial) {
  auto made = with_material({{"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 1, 1, 1}}}}});
  auto& attributes = made.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["COLOR_0"] = made.add_floats({0.5, 0.5, 1, 0.5, 0.5, 1, 0.5, 0.5, 1}, "VEC3");
  const auto even = ImportFolder().import(made);
  EXPECT_EQ(std::get<scene::MetallicRoughness>(only_model(even.scene)).reflectance,
            (scene::RgbColour{0.25, 0.5, 1}));
  EXPECT_FALSE(even.names("colours of vertices"));
  attributes["COLOR_0"] = made.add_floats({1, 1, 1, 0.5, 1, 1, 0, 1, 1}, "VEC3");
  const auto mixed = ImportFolder().import(made);
  EXPECT_EQ(std::get<scene::MetallicRoughness>(only_model(mixed.scene)).reflectance,
            (scene::RgbColour{0.25, 1, 1}));
  EXPECT_TRUE(mixed.names("colours of vertices"));
}

TEST(ImportedNodes, MatricesMultiplyFromTheRoot) {
  auto made = triangle();
  made.json["nodes"][0]["translation"] = {1, 0, 0};
  const double half = std::sqrt(0.5);
  made.add("nodes", {{"rotation", {0, 0, half, half}}, {"scale", {2, 2, 2}}, {"children", {0}}});
  made.add("nodes", {{"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 7, 1}}, {"children", {1}}});
  made.json["scenes"][0]["nodes"] = {2};
  const auto scene = ImportFolder().import(made).scene;
  const Vec3d seen = transform_point(scene.instances.at(0).matrix, {1, 0, 0});
  EXPECT_NEAR(length(seen - Vec3d{0, 4, 7}), 0, 1e-12);
}

TEST(ImportedNodes, WhatIsFlattenedIsLeftOutAndNamed) {
  auto made = triangle();
  made.add("nodes", {{"mesh", 0}, {"scale", {1, 0, 1}}, {"name", "flat"}});
  made.json["scenes"][0]["nodes"] = {0, 1};
  const auto imported = ImportFolder().import(made);
  EXPECT_EQ(imported.scene.instances.size(), 1u);
  EXPECT_TRUE(imported.names("nodes that are flattened"));
}

TEST(ImportedNodes, ASkinIsPosedByItsBonesAndItsOwnPlaceHasNoEffect) {
  auto made = triangle();
  made.json["nodes"][0].update(json{{"skin", 0}, {"translation", {100, 0, 0}}});
  made.add("nodes", {{"translation", {0, 0, 3}}});
  made.json["scenes"][0]["nodes"] = {0, 1};
  const int bound = made.add_floats({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -1, 1}, "MAT4");
  made.add("skins", {{"joints", {1}}, {"inverseBindMatrices", bound}});
  auto& attributes = made.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["JOINTS_0"] = made.add_floats(std::vector<float>(12, 0), "VEC4");
  attributes["WEIGHTS_0"] = made.add_floats({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4");
  const auto scene = ImportFolder().import(made).scene;
  EXPECT_EQ(scene.meshes.at(0).positions.at(1), (Vec3f{1, 0, 2}));
  EXPECT_EQ(scene.instances.at(0).matrix, Mat4{});
}

TEST(ImportedNodes, MorphTargetsHaveTheirWeightAtRest) {
  auto made = triangle();
  auto& mesh = made.json["meshes"][0];
  mesh["primitives"][0]["targets"] =
      json::array({{{"POSITION", made.add_floats({0, 0, 0, 0, 0, 0, 0, 2, 0}, "VEC3")}}});
  mesh["weights"] = {0.5};
  made.add("animations", {{"channels", json::array()}, {"samplers", json::array()}, {"name", "wave"}});
  const auto imported = ImportFolder().import(made);
  EXPECT_EQ(imported.scene.meshes.at(0).positions.at(2), (Vec3f{0, 2, 0}));
  EXPECT_TRUE(imported.names("animations"));
}

TEST(ImportedCamera, LooksAlongMinusZOfItsNode) {
  auto made = triangle();
  made.add("cameras",
           {{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"aspectRatio", 2}, {"znear", 0.1}}}});
  const double half = std::sqrt(0.5);
  made.add("nodes",
           {{"camera", 0}, {"name", "eye"}, {"translation", {5, 1, 0}}, {"rotation", {0, half, 0, half}}});
  made.json["scenes"][0]["nodes"] = {0, 1};
  const auto camera = ImportFolder().import(made, {.camera = "eye", .longer_side = 64}).scene.camera;
  EXPECT_EQ(camera.width_px, 64);
  EXPECT_EQ(camera.height_px, 32);
  EXPECT_NEAR(camera.fov_y_deg, 0.5 * 180 / std::numbers::pi, 1e-12);
  EXPECT_NEAR(length(scene::camera_frame(camera).forward - Vec3d{-1, 0, 0}), 0, 1e-12);
  EXPECT_EQ(camera.position_m, (Vec3d{5, 1, 0}));
}

TEST(ImportedCamera, OrthographicHasHalfExtents) {
  auto made = triangle();
  made.add("cameras", {{"type", "orthographic"},
                       {"orthographic", {{"xmag", 3}, {"ymag", 1.5}, {"znear", 0}, {"zfar", 9}}}});
  made.json["nodes"][0]["camera"] = 0;
  made.add("nodes", {{"camera", 0}, {"name", "other"}, {"translation", {0, 0, 5}}});
  made.json["scenes"][0]["nodes"] = {0, 1};
  const auto imported = ImportFolder().import(made, {.camera = "other"});
  EXPECT_EQ(std::get<scene::Orthographic>(imported.scene.camera.projection).height_m, 3);
  EXPECT_EQ(imported.scene.camera.width_px, 2 * imported.scene.camera.height_px);
  EXPECT_TRUE(imported.names("further cameras"));
  EXPECT_THROW(ImportFolder().import(made, {.camera = "none"}), InputError);
}

TEST(ImportedCamera, IfThereIsNoneAllIsSeen) {
  auto made = triangle();
  made.json["nodes"][0]["translation"] = {40, 50, 60};
  const auto [scene, report] = ImportFolder().import(made);
  const auto frame = scene::camera_frame(scene.camera);
  for (const Vec3d corner : {Vec3d{40, 50, 60}, {41, 50, 60}, {40, 51, 60}}) {
    const Vec3d d = corner - scene.camera.position_m;
    const double depth = dot(d, frame.forward);
    EXPECT_LT(std::abs(dot(d, frame.right)), depth * frame.half_width);
    EXPECT_LT(std::abs(dot(d, frame.up)), depth * frame.half_height);
  }
  ASSERT_EQ(report.choices().size(), 2u);
  EXPECT_NE(report.choices()[0].find("no camera"), std::string::npos);
  EXPECT_NE(report.choices()[1].find("no light"), std::string::npos);
}

TEST(ImportedLights, ASkyIsThatOfTheUserAlone) {
  importer::View view;
  view.sky = 0.5;
  const auto [scene, report] = ImportFolder().import(triangle(), view);
  EXPECT_EQ(scene.environment.radiance, (scene::RgbColour{0.5, 0.5, 0.5}));
  EXPECT_TRUE(scene.lights.empty());
  EXPECT_EQ(report.choices().size(), 1u);
}

TEST(ImportedLights, ShineAlongMinusZWithTheirIntensity) {
  auto made = triangle();
  made.json["extensions"]["KHR_lights_punctual"]["lights"] = json::array(
      {{{"type", "directional"}, {"color", {1, 0.5, 0}}, {"intensity", 2}},
       {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.2}, {"outerConeAngle", 0.4}}}, {"range", 3}}});
  made.json["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0;
  made.add("nodes", {{"scale", {3, 3, 3}},
                     {"translation", {0, 2, 0}},
                     {"extensions", {{"KHR_lights_punctual", {{"light", 1}}}}}});
  made.json["scenes"][0]["nodes"] = {0, 1};
  const auto imported = ImportFolder().import(made);
  ASSERT_EQ(imported.scene.lights.size(), 2u);
  const auto& sun = imported.scene.lights[0];
  EXPECT_EQ(sun.radiance, (scene::RgbColour{2, 1, 0}));
  EXPECT_NEAR(length(transform_direction(sun.matrix, {0, -1, 0}) - Vec3d{0, 0, -1}), 0, 1e-12);
  const auto& spot = std::get<scene::SpotShape>(imported.scene.lights[1].shape);
  EXPECT_NEAR(spot.inner_deg, 0.2 * 180 / std::numbers::pi, 1e-9);
  EXPECT_NEAR(spot.outer_deg, 0.4 * 180 / std::numbers::pi, 1e-9);
  EXPECT_EQ(transform_point(imported.scene.lights[1].matrix, {}), (Vec3d{0, 2, 0}));
  EXPECT_EQ(imported.scene.environment.radiance, scene::RgbColour{});
  EXPECT_TRUE(imported.names("how spots fall off"));
  EXPECT_TRUE(imported.names("the range beyond which"));
}

TEST(ImportedMaterial, IsThatOfGltf) {
  const auto imported = ImportFolder().import(with_material(
      {{"pbrMetallicRoughness",
        {{"baseColorFactor", {0.1, 0.2, 0.3, 1}}, {"metallicFactor", 0.25}, {"roughnessFactor", 0.5}}}}));
  const auto& m = std::get<scene::MetallicRoughness>(only_model(imported.scene));
  EXPECT_EQ(m.reflectance, (scene::RgbColour{0.1, 0.2, 0.3}));
  EXPECT_EQ(m.metallic, 0.25);
  EXPECT_EQ(m.roughness, 0.5);
  EXPECT_TRUE(imported.report.remarks().empty());
}

// The extension's own example: rotation, offset and scale of (u, v) with v from the top.
TEST(ImportedMaterial, TexturesAreTurnedAsTheFileSays) {
  auto made = with_material({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
  const double r = 0.3;
  made.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]
           ["KHR_texture_transform"] = {{"offset", {0.1, 0.2}}, {"rotation", r}, {"scale", {2, 3}}};
  const auto scene = ImportFolder().import(made).scene;
  const auto& use = std::get<scene::MetallicRoughness>(only_model(scene)).texture;
  ASSERT_TRUE(use);
  const double u = 0.7;
  const double v_top = 0.4;
  const Vec3d seen = transform_point(use->matrix, {u, 1 - v_top, 0});
  EXPECT_NEAR(seen.x, 2 * std::cos(r) * u + 3 * std::sin(r) * v_top + 0.1, 1e-12);
  EXPECT_NEAR(1 - seen.y, -2 * std::sin(r) * u + 3 * std::cos(r) * v_top + 0.2, 1e-12);
}

TEST(ImportedMaterial, MetalAndRoughnessOfATextureAreMeansOfTriangles) {
  auto made = with_material({{"pbrMetallicRoughness", {{"metallicRoughnessTexture", {{"index", 0}}}}}});
  const auto mixed = ImportFolder().import(made);
  // Red and blue: nothing is rough, and what is right of u = 1/2 is metal: a quarter of the triangle.
  const auto& m = std::get<scene::MetallicRoughness>(only_model(mixed.scene));
  EXPECT_EQ(m.metallic, 0.25);
  EXPECT_EQ(m.roughness, 0.01);
  EXPECT_TRUE(mixed.names("textures of metal and roughness"));
  made.json["images"][0]["bufferView"] =
      made.json["images"][static_cast<std::size_t>(made.add_image({{0, 51, 102}, {0, 51, 102}}))]
               ["bufferView"];
  const auto even = ImportFolder().import(made);
  const auto& e = std::get<scene::MetallicRoughness>(only_model(even.scene));
  EXPECT_NEAR(e.metallic, 0.4, 1e-7);
  EXPECT_NEAR(e.roughness, 0.2, 1e-7);
  EXPECT_FALSE(even.names("textures of metal"));
}

TEST(ImportedMaterial, EmissionGlassAndLambertAreTheirOwnTypes) {
  const auto of = [](const json& material) {
    const auto scene = ImportFolder().import(with_material(material)).scene;
    return only_model(scene);
  };
  const json black{{"baseColorFactor", {0, 0, 0, 1}}};
  const json no_gloss{{"KHR_materials_specular", {{"specularFactor", 0}}}};
  auto lamp_extensions = no_gloss;
  lamp_extensions["KHR_materials_emissive_strength"] = {{"emissiveStrength", 4}};
  const auto lamp =
      of({{"pbrMetallicRoughness", black}, {"emissiveFactor", {1, 0.5, 0}}, {"extensions", lamp_extensions}});
  EXPECT_EQ(std::get<scene::Emission>(lamp).radiance, (scene::RgbColour{4, 2, 0}));
  const auto wall = of({{"pbrMetallicRoughness", {{"metallicFactor", 0}}}, {"extensions", no_gloss}});
  EXPECT_EQ(std::get<scene::Lambert>(wall).reflectance, (scene::RgbColour{1, 1, 1}));
  const json clear{{"KHR_materials_transmission", {{"transmissionFactor", 1}}},
                   {"KHR_materials_ior", {{"ior", 1.3}}},
                   {"KHR_materials_volume", {{"thicknessFactor", 1}}}};
  const auto glass = of({{"pbrMetallicRoughness", {{"roughnessFactor", 0}}}, {"extensions", clear}});
  EXPECT_EQ(std::get<scene::Glass>(glass).ior, 1.3);
  const auto frosted = of({{"pbrMetallicRoughness", {{"roughnessFactor", 0.5}}}, {"extensions", clear}});
  EXPECT_EQ(std::get<scene::RoughGlass>(frosted).alpha, 0.25);
}

TEST(ImportedMaterial, WhatIsNotUnderstoodIsNamed) {
  const std::vector<std::pair<json, std::string>> cases{
      {{{"normalTexture", {{"index", 0}, {"scale", -1}}}}, "normal maps of negative"},
      {{{"normalTexture", {{"index", 0}, {"extensions", {{"KHR_texture_transform", {{"rotation", 1}}}}}}}},
       "normal maps that a texture transform turns"},
      {{{"occlusionTexture", {{"index", 0}}}}, "occlusion maps"},
      {{{"alphaMode", "BLEND"}, {"extensions", {{"KHR_materials_unlit", json::object()}}}},
       "transparency of what emits"},
      {{{"doubleSided", false}}, "materials that show their front alone"},
      {{{"emissiveFactor", {1, 1, 1}}}, "surfaces that emit and reflect"},
      {{{"emissiveFactor", {1, 1, 1}}, {"emissiveTexture", {{"index", 0}}}}, "emission by a texture"},
      {{{"extensions", {{"KHR_materials_clearcoat", {{"clearcoatFactor", 1}}}}}}, "KHR_materials_clearcoat"},
      {{{"extensions", {{"KHR_materials_unlit", json::object()}}}}, "unlit materials"},
      {{{"extensions", {{"KHR_materials_ior", {{"ior", 1.3}}}}},
        {"pbrMetallicRoughness", {{"metallicFactor", 0}}}},
       "index of refraction"},
      {{{"extensions", {{"KHR_materials_specular", {{"specularFactor", 0.5}}}}},
        {"pbrMetallicRoughness", {{"metallicFactor", 0}}}},
       "strength of reflections"},
      {{{"extensions", {{"KHR_materials_transmission", {{"transmissionFactor", 1}}}}}},
       "thin sheets that transmit"},
      {{{"pbrMetallicRoughness", {{"metallicFactor", 0.5}, {"roughnessFactor", 0}}}},
       "roughness below 0.01"}};
  for (const auto& [material, named] : cases) {
    const auto imported = ImportFolder().import(with_material(material));
    EXPECT_TRUE(imported.names(named)) << material;
  }
}

TEST(ImportedMaterial, NormalMapsHaveTheirStrengthAndTheirCoordinates) {
  auto made = with_material({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}},
                             {"normalTexture", {{"index", 0}, {"scale", 0.5}, {"texCoord", 1}}}});
  const int uvs = made.add_floats({0.25, 1, 0.5, 1, 0.25, 0}, "VEC2");
  made.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_1"] = uvs;
  const auto imported = ImportFolder().import(made);
  const auto& map = imported.scene.materials.at(0).detail.normal_map;
  ASSERT_TRUE(map);
  EXPECT_EQ(map->strength, 0.5);
  EXPECT_EQ(map->texture.uv_set, 1);
  EXPECT_EQ(texture_at(imported.scene, map->texture).encoding, scene::Encoding::Linear);
  EXPECT_EQ(imported.scene.textures.size(), 2u) << "the same image as colours and as numbers";
  EXPECT_EQ(imported.scene.meshes.at(0).second_uvs, (std::vector<Vec2f>{{0.25, 0}, {0.5, 0}, {0.25, 1}}));
  EXPECT_EQ(imported.scene.meshes.at(0).uvs, (std::vector<Vec2f>{{0, 0}, {1, 0}, {0, 1}}));
}

// Exporters write the coordinates that they know, and materials of another program ask for others.
TEST(ImportedMaterial, CoordinatesThatTheMeshLacksAreNamed) {
  const json elsewhere{{"index", 0}, {"texCoord", 1}};
  const json moved{{"index", 0}, {"extensions", {{"KHR_texture_transform", {{"texCoord", 1}}}}}};
  for (const json& material : {json{{"pbrMetallicRoughness", {{"baseColorTexture", elsewhere}}}},
                               json{{"pbrMetallicRoughness", {{"baseColorTexture", moved}}}},
                               json{{"pbrMetallicRoughness", {{"metallicRoughnessTexture", elsewhere}}}},
                               json{{"normalTexture", elsewhere}}, json{{"emissiveTexture", elsewhere}}}) {
    auto made = with_material(material);
    EXPECT_TRUE(
        ImportFolder().import(made).names("textures of meshes without their coordinates (TEXCOORD_1)"))
        << material;
    auto& attributes = made.json["meshes"][0]["primitives"][0]["attributes"];
    attributes["TEXCOORD_1"] = attributes["TEXCOORD_0"];
    EXPECT_FALSE(ImportFolder().import(made).names("textures of meshes without")) << material;
  }
}

TEST(ImportedMaterial, OneSetOfCoordinatesIsTheFirst) {
  auto made = with_material({{"normalTexture", {{"index", 0}, {"texCoord", 1}}}});
  made.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_1"] =
      made.add_floats({0.25, 1, 0.5, 1, 0.25, 0}, "VEC2");
  const auto imported = ImportFolder().import(made);
  EXPECT_EQ(imported.scene.materials.at(0).detail.normal_map->texture.uv_set, 0);
  EXPECT_EQ(imported.scene.meshes.at(0).uvs, (std::vector<Vec2f>{{0.25, 0}, {0.5, 0}, {0.25, 1}}));
  EXPECT_TRUE(imported.scene.meshes.at(0).second_uvs.empty());
}

// Those along the coordinates say no more than the coordinates do.
TEST(ImportedMaterial, TangentsAreNamedWhereTheyAreNotThoseOfTheCoordinates) {
  const auto names_tangents = [](const std::vector<float>& one, bool has_map) {
    auto made = has_map ? with_material({{"normalTexture", {{"index", 0}}}}) : triangle();
    std::vector<float> all;
    for (int i = 0; i < 3; ++i) all.insert(all.end(), one.begin(), one.end());
    made.json["meshes"][0]["primitives"][0]["attributes"]["TANGENT"] = made.add_floats(all, "VEC4");
    return ImportFolder().import(made).names("tangents under normal maps");
  };
  EXPECT_FALSE(names_tangents({1, 0, 0, 1}, true));
  EXPECT_TRUE(names_tangents({1, 0, 0, -1}, true)) << "v grows to the other side";
  EXPECT_TRUE(names_tangents({0, 1, 0, 1}, true));
  EXPECT_FALSE(names_tangents({0, 1, 0, 1}, false)) << "nothing asks for them";
}

// A row of black texels with these alphas, of 255.
json alpha_texture(MadeGltf& made, const std::string& alphas) {
  constexpr int kRgba = 6;
  std::string row(1, '\0');
  for (const char alpha : alphas) row += std::string(3, '\0') + alpha;
  const auto png = image_test::png_bytes(static_cast<std::uint32_t>(alphas.size()), 1, 8, kRgba, row);
  const int added = made.add("images", {{"bufferView", made.add_view(png)}, {"mimeType", "image/png"}});
  return {{"index", made.add("textures", {{"source", added}})}};
}

std::vector<float> texels_of(const scene::Scene& scene, const scene::TextureUse& use) {
  return image::read_linear_rgb(texture_at(scene, use).file, image::Encoded::Numbers).pixels;
}

TEST(ImportedMaterial, AlphaIsOpacity) {
  auto made = with_material(json::object());
  auto& material = made.json["materials"][0];
  material["pbrMetallicRoughness"] = {{"baseColorFactor", {1, 1, 1, 0.5}}};
  EXPECT_EQ(ImportFolder().import(made).scene.materials.at(0).detail, scene::SurfaceDetail{});
  material["alphaMode"] = "BLEND";
  EXPECT_EQ(ImportFolder().import(made).scene.materials.at(0).detail.opacity, 0.5);
  material["alphaMode"] = "MASK";
  EXPECT_EQ(ImportFolder().import(made).scene.materials.at(0).detail.opacity, 1);
  material["alphaCutoff"] = 0.6;
  EXPECT_EQ(ImportFolder().import(made).scene.materials.at(0).detail.opacity, 0);
  material["alphaCutoff"] = 0.3;
  material["pbrMetallicRoughness"]["baseColorTexture"] =
      alpha_texture(made, std::string("\x00\x33\xcc\xff", 4));
  const ImportFolder folder;
  const auto mask = folder.import(made);
  const auto& detail = mask.scene.materials.at(0).detail;
  EXPECT_EQ(detail.opacity, 1);
  EXPECT_EQ(texels_of(mask.scene, detail.opacity_texture.value()),
            (std::vector<float>{0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1}))
      << "0.8 times 0.5 is 0.4, which is 0.3 and more";
  EXPECT_TRUE(mask.names("alpha masks between their texels"));
  material["alphaMode"] = "BLEND";
  const auto blend = folder.import(made);
  EXPECT_EQ(blend.scene.materials.at(0).detail.opacity, 0.5);
  EXPECT_NEAR(texels_of(blend.scene, blend.scene.materials.at(0).detail.opacity_texture.value()).at(3), 0.2,
              1e-3);
}

TEST(ImportedMaterial, TexturesGoOnBeyondTheirEdgesAsTheSamplerSays) {
  auto made = with_material({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
  made.add("samplers", {{"magFilter", 9728}, {"wrapS", 33648}, {"wrapT", 33071}});
  made.json["textures"][0]["sampler"] = 0;
  const auto texture = ImportFolder().import(made).scene.textures.at(0);
  EXPECT_EQ(texture.filter, scene::Filter::Nearest);
  EXPECT_EQ(texture.wrap_u, scene::Wrap::Mirror);
  EXPECT_EQ(texture.wrap_v, scene::Wrap::Clamp);
  made.json["textures"][0].erase("source");
  EXPECT_TRUE(ImportFolder().import(made).names("textures in a format of an extension"));
}

TEST(ImportReport, GroupsAndCounts) {
  importer::Report report;
  for (const char* where : {"a", "b", "a", "c", "d"}) report.not_understood("normal maps", "none", where);
  ASSERT_EQ(report.remarks().size(), 1u);
  EXPECT_EQ(text_of(report.remarks()[0]), "normal maps: 4 (a, b, c, ...): none");
}

}  // namespace

#include "adapters/gltf/gltf.h"

#include "adapters/export.h"
#include "adapters/lights_as_meshes.h"
#include "adapters/material_meshes.h"
#include "base/files.h"
#include "golden/read_back.h"
#include "golden/read_gltf.h"
#include "golden/written_gltf.h"
#include "image/image_io.h"
#include "registry/features.h"
#include "scene/camera_frame.h"
#include "scene/geometry/generators.h"
#include "scene/load/load_scene.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

/// What the exporter to glTF writes is read back and compared with the scene that it came from.
namespace {

using namespace orbs;
using nlohmann::json;
namespace fs = std::filesystem;

class Gltf : public tests::WrittenGltf {};

// As a renderer gets it that declares all that the exporter writes.
scene::Scene suite_scene(const std::string& name) {
  registry::Renderer renderer;
  renderer.name = "reader";
  renderer.format.name = "gltf";
  renderer.support.declares = registry::parse_features("G5/M8-(7)/L3/A4");
  const auto scene = scene::load_scene(fs::path(ORBS_SOURCE_DIR) / "data/cases" / (name + ".json"));
  auto prepared = adapters::prepare_scene(renderer, scene);
  if (const auto* reason = std::get_if<std::string>(&prepared)) ADD_FAILURE() << name << ": " << *reason;
  return std::get<scene::Scene>(prepared);
}

// A cube of half size 1 in the one material, at the places.
scene::Scene cubes(const scene::Material& material, const std::vector<Mat4>& places) {
  scene::Scene scene;
  scene.camera.position_m = {0, 0, 9};
  scene.materials = {material};
  scene.meshes = {scene::make_cube({1})};
  scene.meshes[0].triangle_materials.assign(12, 0);
  for (const Mat4& place : places) scene.instances.push_back({"cube", 0, place, {}});
  return scene;
}

const json& texture_info_of(const json& material) {
  static const json kNone = json::object();
  if (material.contains("emissiveTexture")) return material.at("emissiveTexture");
  const json& base = material.at("pbrMetallicRoughness");
  return base.contains("baseColorTexture") ? base.at("baseColorTexture") : kNone;
}

// By the name of the material, all nodes of the file.
std::map<std::string, tests::Moments> moments_of(const tests::GltfFile& file) {
  std::map<std::string, tests::Moments> out;
  for (const json& node : file.json.at("nodes")) {
    if (!node.contains("mesh")) continue;
    const std::size_t index = node.at("mesh");
    const std::size_t place = file.json.at("meshes").at(index).at("primitives").at(0).at("material");
    const json& material = file.json.at("materials").at(place);
    auto mesh = tests::read_mesh(file, static_cast<int>(index));
    for (Vec2f& uv : mesh.uvs) uv = tests::seen_uv(texture_info_of(material), uv);
    tests::add_mesh(out[material.at("name")], mesh, tests::node_matrix(node), false);
  }
  return out;
}

std::map<std::string, tests::Moments> moments_of(const scene::Scene& scene) {
  constexpr Vec2f kUntextured{0, 1};  // which is (0, 0) from the top
  std::map<std::string, tests::Moments> out;
  for (const auto& [material, moments] : tests::moments_of_materials(scene, kUntextured))
    out[material_at(scene, material).name] = moments;
  return out;
}

void expect_near(Vec3d a, Vec3d b, double most, const std::string& what) {
  EXPECT_LE(length(a - b), most) << what << ": " << a.x << " " << a.y << " " << a.z << " instead of " << b.x
                                 << " " << b.y << " " << b.z;
}

void expect_same_surfaces(const scene::Scene& scene, const tests::GltfFile& file) {
  const auto found = moments_of(file);
  for (const auto& [name, moments] : moments_of(scene)) {
    ASSERT_TRUE(found.contains(name)) << name;
    const auto& read = found.at(name);
    const double most = 1e-5 * moments.area_m2;
    EXPECT_NEAR(read.area_m2, moments.area_m2, most) << name;
    expect_near(read.centre, moments.centre, 10 * most, name + " centre");
    expect_near(read.normal, moments.normal, most, name + " normal");
    EXPECT_NEAR(read.uv.x, moments.uv.x, 10 * most) << name;
    EXPECT_NEAR(read.uv.y, moments.uv.y, 10 * most) << name;
  }
}

double area_m2(const scene::Light& light) {
  const Vec3d u = transform_direction(light.matrix, {1, 0, 0});
  const double scale = length(cross(u, transform_direction(light.matrix, {0, 0, 1})));
  if (const auto* rect = std::get_if<scene::RectShape>(&light.shape))
    return 4 * rect->half_width_m * rect->half_length_m * scale;
  if (const auto* disk = std::get_if<scene::DiskShape>(&light.shape))
    return std::numbers::pi * disk->radius_m * disk->radius_m * scale;
  const double r = std::get<scene::SphereShape>(light.shape).radius_m;
  return 4 * std::numbers::pi * r * r * dot(u, u);
}

Vec3d emitted(const json& material) {
  const json& factor = material.at("emissiveFactor");
  double strength = 1;
  if (const auto extensions = material.value("extensions", json::object());
      extensions.contains("KHR_materials_emissive_strength"))
    strength = extensions.at("KHR_materials_emissive_strength").at("emissiveStrength");
  for (const json& part : factor) EXPECT_LE(part.get<double>(), 1);
  return Vec3d{factor.at(0), factor.at(1), factor.at(2)} * strength;
}

const json& material_named(const tests::GltfFile& file, const std::string& name) {
  const json& all = file.json.at("materials");
  return *std::find_if(all.begin(), all.end(), [&](const json& one) { return one.at("name") == name; });
}

void expect_same_lights(const scene::Scene& scene, const tests::GltfFile& file) {
  const auto found = moments_of(file);
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const scene::Light& light = scene.lights[i];
    const auto name = scene::display_name("light", light.name, i);
    const auto& read = found.at(name);
    const double area = area_m2(light);
    EXPECT_NEAR(read.area_m2, area, 1e-6 * area) << name;
    expect_near(read.centre / area, transform_point(light.matrix, {}), 1e-5, name + " centre");
    const Vec3d radiance = emitted(material_named(file, name));
    expect_near(radiance, light.radiance, 1e-12 * length(radiance), name);
    if (std::holds_alternative<scene::SphereShape>(light.shape)) continue;
    const Vec3d down = normalised(transform_normal(inverse(light.matrix).value(), {0, -1, 0}));
    expect_near(normalised(read.normal), down, 1e-6, name + " facing");
  }
}

void expect_same_camera(const scene::Scene& scene, const tests::GltfFile& file) {
  const auto frame = scene::camera_frame(scene.camera);
  const Mat4 m = tests::node_matrix(file.json.at("nodes").back());
  expect_near(transform_direction(m, {0, 0, -1}), frame.forward, 1e-12, "forward");
  expect_near(transform_direction(m, {0, 1, 0}), frame.up, 1e-12, "up");
  expect_near(transform_point(m, {}), scene.camera.position_m, 0, "eye");
  const json& lens = file.json.at("cameras").at(0).at("perspective");
  EXPECT_NEAR(std::tan(lens.at("yfov").get<double>() / 2), frame.half_height, 1e-12);
  EXPECT_NEAR(lens.at("aspectRatio").get<double>(), frame.half_width / frame.half_height, 1e-12);
  const json& extras = file.json.at("scenes").at(0).at("extras").at("orbs");
  EXPECT_EQ(extras.at("width"), scene.camera.width_px);
  EXPECT_EQ(extras.at("height"), scene.camera.height_px);
  EXPECT_EQ(extras.at("trace_depth"), scene.trace_depth);
}

TEST_F(Gltf, SuiteScenesReadBackAsTheyWere) {
  for (const char* name :
       {"orbs/a1_trace_depth/248-full", "orbs/a2_paths_basic/a2-mirror", "orbs/a3_paths_glass/a3-water",
        "orbs/a4_paths_glossy_glass/a4-ball", "orbs/g1_primitive_format/g1-attributes",
        "orbs/g2_single_mesh/g2-camera-wide", "orbs/g3_inst_matrices/g3-matrices",
        "orbs/g4_inst_change_material/g4-lambert", "orbs/g5_inst_remaplist/078-remap",
        "orbs/l1_area_light/246", "orbs/l2_sphere_light/201", "orbs/l3_light_matrices/215",
        "orbs/l3_light_matrices/224", "orbs/m2_emission/123-red", "orbs/m3_mirror/102",
        "orbs/m4_lambert_texture/103", "orbs/m5_texture_matrices/110", "orbs/m6_emission_texture/124",
        "orbs/m8_smooth_glass/113"}) {
    SCOPED_TRACE(name);
    const scene::Scene scene = suite_scene(name);
    const auto file = written(scene);
    expect_same_camera(scene, file);
    expect_same_lights(scene, file);
    expect_same_surfaces(scene, file);
  }
}

TEST_F(Gltf, WhatItLacksIsRefusedWithAReason) {
  const auto reason_of = [](const scene::Scene& scene) {
    const auto limits = adapters::gltf_limits(scene);
    return limits.empty() ? "none" : limits.front();
  };
  const auto reason_for = [&](const scene::MaterialModel& model) {
    return reason_of(cubes({"m", model}, {Mat4{}}));
  };
  EXPECT_EQ(
      reason_for(scene::Mirror{{0.9, 0.8, 0.7}}),
      "material 'm' is a coloured mirror: glTF's colours of reflections turn grey towards grazing angles");
  EXPECT_NE(reason_for(scene::Ggx{{0.9, 0.8, 0.7}, 0.1}).find("coloured glossy reflector"),
            std::string::npos);
  EXPECT_NE(reason_for(scene::Ggx{{0.9, 0.9, 0.9}, 0.4}).find("a product of two sides"), std::string::npos);
  EXPECT_NE(reason_for(scene::Glass{{1, 1, 0.9}, 1.5}).find("tinted glass"), std::string::npos);
  EXPECT_EQ(reason_for(scene::Glass{{1, 1, 1}, 0.75}),
            "material 'm' has the index 0.75: glTF has none below 1");
  EXPECT_NE(reason_for(scene::OrenNayar{{1, 1, 1}, 0.5, {}}).find("Lambert"), std::string::npos);
  EXPECT_NE(reason_for(scene::Conductor{}).find("Schlick"), std::string::npos);
  scene::Scene scene = cubes({"m", scene::Lambert{}}, {Mat4{}});
  scene.lights = {{"lamp", scene::RectShape{1, 1}, {1, 1, 1}, {}, {}}};
  scene.lights[0].reflectance = {0.1, 0.1, 0.1};
  EXPECT_NE(reason_of(scene).find("light 'lamp' reflects"), std::string::npos);
  EXPECT_NE(reason_of(scene::load_scene(fs::path(ORBS_SOURCE_DIR) / "data/cases/orbs/l4_light_ies/232.json"))
                .find("IES profile"),
            std::string::npos);
}

TEST_F(Gltf, TexturesOfMoreThanEightBitsAreRefused) {
  scene::Scene scene = cubes({"m", scene::Lambert{{1, 1, 1}, scene::TextureUse{}}}, {Mat4{}});
  image::Image image = image::make_image(2, 2, {"R", "G", "B"});
  image::write_exr(image, folder_ / "floats.exr");
  scene.textures = {{"t", folder_ / "floats.exr"}};
  EXPECT_EQ(adapters::gltf_limits(scene).at(0), "texture 't' holds floats: glTF's images have 8 bits");
  image::write_png(image, folder_ / "bytes.png");
  scene.textures[0].file = folder_ / "bytes.png";
  EXPECT_TRUE(adapters::gltf_limits(scene).empty());
}

// The reflectance that a reader computes by the specification.
TEST_F(Gltf, MirrorsReflectTheSameShareAtAllAngles) {
  for (const double share : {0.0, 0.25, 0.85, 1.0})
    for (const scene::MaterialModel& model :
         {scene::MaterialModel{scene::Mirror{{share, share, share}}},
          scene::MaterialModel{scene::Ggx{{share, share, share}, 0.0625}}}) {
      const auto file = written(cubes({"m", model}, {Mat4{}}));
      const json& material = file.json.at("materials").at(0);
      for (const double cosine : {1.0, 0.5, 0.1, 0.0})
        EXPECT_NEAR(tests::reflectance(material, cosine), share, 1e-12) << material.dump(1);
      const json& base = material.at("pbrMetallicRoughness");
      EXPECT_EQ(base.at("roughnessFactor").get<double>(),
                std::holds_alternative<scene::Mirror>(model) ? 0 : 0.25);
      if (share == 1) continue;
      for (const json& part : {base.at("baseColorFactor").at(0), base.at("baseColorFactor").at(2)})
        EXPECT_EQ(part, 0);
    }
}

TEST_F(Gltf, LambertReflectsNothingAtTheSurface) {
  const auto file = written(cubes({"m", scene::Lambert{{0.1, 0.2, 0.3}, {}}}, {Mat4{}}));
  const json& material = file.json.at("materials").at(0);
  for (const double cosine : {1.0, 0.5, 0.0}) EXPECT_EQ(tests::reflectance(material, cosine), 0);
  EXPECT_EQ(material.at("pbrMetallicRoughness").at("baseColorFactor"), json::array({0.1, 0.2, 0.3, 1}));
  EXPECT_EQ(material.at("doubleSided"), true);
}

TEST_F(Gltf, GlassIsTheBoundaryOfAVolume) {
  const auto file = written(cubes({"m", scene::RoughGlass{{1, 1, 1}, 1.33, 0.0625}}, {Mat4{}}));
  const json& material = file.json.at("materials").at(0);
  const json& extensions = material.at("extensions");
  EXPECT_EQ(extensions.at("KHR_materials_ior").at("ior"), 1.33);
  EXPECT_EQ(extensions.at("KHR_materials_transmission").at("transmissionFactor"), 1);
  EXPECT_GT(extensions.at("KHR_materials_volume").at("thicknessFactor"), 0);
  EXPECT_FALSE(extensions.contains("KHR_materials_specular")) << "its factor is 1";
  EXPECT_EQ(material.at("pbrMetallicRoughness").at("roughnessFactor"), 0.25);
  EXPECT_EQ(material.at("pbrMetallicRoughness").at("baseColorFactor"), json::array({1, 1, 1, 1}));
  EXPECT_FALSE(material.contains("doubleSided"));
}

TEST_F(Gltf, EmissionIsFactorTimesStrength) {
  for (const Vec3d radiance : {Vec3d{0.5, 0.25, 0}, Vec3d{7, 0.1, 3}, Vec3d{1, 1, 1}}) {
    const auto file = written(cubes({"m", scene::Emission{radiance, {}}}, {Mat4{}}));
    const json& material = file.json.at("materials").at(0);
    expect_near(emitted(material), radiance, 1e-12, "radiance");
    EXPECT_EQ(material.at("extensions").contains("KHR_materials_emissive_strength"), radiance.x > 1);
    EXPECT_EQ(material.at("doubleSided"), true);
  }
}

TEST_F(Gltf, ExtensionsAreNamedAndThoseThatCountAreRequired) {
  const auto diffuse = written(cubes({"m", scene::Lambert{}}, {Mat4{}}));
  EXPECT_EQ(diffuse.json.at("extensionsUsed"), json::array({"KHR_materials_specular"}));
  EXPECT_EQ(diffuse.json.at("extensionsRequired"), json::array({"KHR_materials_specular"}));
  const auto glass = written(cubes({"m", scene::Glass{{1, 1, 1}, 1.5}}, {Mat4{}}));
  EXPECT_EQ(glass.json.at("extensionsRequired"),
            json::array({"KHR_materials_ior", "KHR_materials_transmission"}));
  EXPECT_EQ(glass.json.at("extensionsUsed").size(), 3U) << "and that of the volume";
}

TEST_F(Gltf, InstancesShareAMeshUnlessTheirAxesAreNotAtRightAngles) {
  const Mat4 turned = translation({1, 2, 3}) * rotation_y(30) * scaling({1, 2, 3});
  const Mat4 mirrored = translation({5, 0, 0}) * rotation_z(20) * scaling({-1, 2, 1});
  const Mat4 sheared = translation({0, 7, 0}) * scaling({1, 2, 1}) * rotation_z(30);
  const scene::Scene scene =
      cubes({"m", scene::Lambert{}}, {Mat4{}, turned, mirrored, sheared, rotation_x(180)});
  const auto file = written(scene);
  EXPECT_EQ(file.json.at("meshes").size(), 2U);
  const json& nodes = file.json.at("nodes");
  ASSERT_EQ(nodes.size(), 6U);
  EXPECT_EQ(nodes.at(3).at("mesh"), 1);
  for (const std::size_t i : {0U, 1U, 2U, 4U}) {
    EXPECT_EQ(nodes.at(i).at("mesh"), 0);
    const Mat4 matrix = tests::node_matrix(nodes.at(i));
    for (std::size_t k = 0; k < 16; ++k) EXPECT_NEAR(matrix.m[k], scene.instances[i].matrix.m[k], 1e-12) << i;
  }
  EXPECT_FALSE(nodes.at(0).contains("rotation"));
  expect_same_surfaces(scene, file);
}

// The plane of the generators is wound against its normal; ORB.S asks the normals alone.
TEST_F(Gltf, FrontsAreWhereTheNormalsPoint) {
  scene::Scene scene =
      cubes({"m", scene::Glass{{1, 1, 1}, 1.5}}, {Mat4{}, scaling({1, -1, 1}) * rotation_z(30)});
  scene.meshes.push_back(scene::make_plane({1}));
  scene.meshes[1].triangle_materials.assign(2, 0);
  for (Vec3f& normal : scene.meshes[1].normals) normal = normal * 3;
  scene.instances.push_back({"plane", 1, {}, {}});
  const auto file = written(scene);
  for (int i = 0; i < static_cast<int>(file.json.at("meshes").size()); ++i) {
    const auto mesh = tests::read_mesh(file, i);
    for (const auto& triangle : mesh.triangles) {
      const Vec3f a = mesh.positions[triangle[0]];
      const Vec3f face = cross(mesh.positions[triangle[1]] - a, mesh.positions[triangle[2]] - a);
      EXPECT_GT(dot(face, mesh.normals[triangle[0]]), 0);
      EXPECT_NEAR(length(mesh.normals[triangle[0]]), 1, 1e-6);
    }
  }
}

TEST_F(Gltf, PositionsHaveTheirBounds) {
  const auto file = written(suite_scene("orbs/m8_smooth_glass/113"));
  for (const json& mesh : file.json.at("meshes")) {
    const int accessor = mesh.at("primitives").at(0).at("attributes").at("POSITION");
    const json& bounds = file.json.at("accessors").at(static_cast<std::size_t>(accessor));
    Vec3f low{1e30F, 1e30F, 1e30F};
    Vec3f high = -low;
    for (const Vec3f p : tests::read_vec3(file, accessor)) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    EXPECT_EQ(bounds.at("min"), json::array({low.x, low.y, low.z}));
    EXPECT_EQ(bounds.at("max"), json::array({high.x, high.y, high.z}));
  }
}

TEST_F(Gltf, TexturesAreEmbeddedUpright) {
  scene::Scene scene = cubes({"m", scene::Lambert{{0.5, 1, 1}, scene::TextureUse{}}}, {Mat4{}});
  image::Image image = image::make_image(2, 3, {"R", "G", "B", "A"});
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = static_cast<float>(10 * i) / 255;
  image::write_png(image, folder_ / "texture.png");
  scene.textures = {{"t", folder_ / "texture.png", scene::Wrap::Repeat, scene::Wrap::Clamp}};
  const auto file = written(scene);
  write_file(folder_ / "embedded.png", tests::read_view(file, file.json.at("images").at(0).at("bufferView")));
  const image::Image embedded = image::read_image(folder_ / "embedded.png");
  EXPECT_EQ(embedded.channels, (std::vector<std::string>{"R", "G", "B"}));
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 2; ++x)
      for (std::size_t c = 0; c < 3; ++c) EXPECT_FLOAT_EQ(embedded.at(x, y, c), image.at(x, y, c));
  const json& sampler = file.json.at("samplers").at(0);
  EXPECT_EQ(sampler.at("wrapS"), 10497);
  EXPECT_EQ(sampler.at("wrapT"), 33071);
  EXPECT_EQ(file.json.at("materials").at(0).at("pbrMetallicRoughness").at("baseColorFactor").at(0), 0.5);
}

TEST_F(Gltf, TextureMatricesAreTransformsOrApplied) {
  const Mat4 shear{{2, 1, 0, 0.5, 0, 3, 0, 0.25, 0, 0, 1, 0, 0, 0, 0, 1}};
  const Mat4 turned = translation({0.5, -7, 0}) * rotation_z(30) * scaling({3, -2, 1});
  image::write_png(image::make_image(2, 2, {"R", "G", "B"}), folder_ / "texture.png");
  for (const Mat4& matrix : {shear, turned, scaling({-1, 1, 1})}) {
    scene::Scene scene = cubes({"m", scene::Lambert{{1, 1, 1}, scene::TextureUse{0, matrix}}}, {Mat4{}});
    scene.textures = {{"t", folder_ / "texture.png"}};
    const auto file = written(scene);
    EXPECT_EQ(texture_info_of(file.json.at("materials").at(0)).contains("extensions"), matrix != shear);
    expect_same_surfaces(scene, file);
  }
}

TEST_F(Gltf, SameSceneGivesTheSameBytes) {
  const scene::Scene scene = suite_scene("orbs/l3_light_matrices/215");
  written(scene);
  const std::string first = read_file(folder_ / "scene.glb");
  written(scene);
  EXPECT_EQ(first, read_file(folder_ / "scene.glb"));
}

TEST_F(Gltf, AnEmptySceneIsACamera) {
  scene::Scene scene;
  scene.camera.position_m = {0, 0, 1};
  scene.trace_depth = scene::kUnlimitedDepth;
  const auto file = written(scene);
  EXPECT_EQ(file.json.at("nodes").size(), 1U);
  EXPECT_FALSE(file.json.contains("buffers"));
  EXPECT_EQ(file.json.at("scenes").at(0).at("extras").at("orbs").at("trace_depth"), "unlimited");
}

// Front and casing touch along the edge and hold a space that no light leaves.
TEST(LightsAsMeshes, ACasingClosesTheBackOfFlatLights) {
  scene::Scene scene;
  scene.lights = {{"a", scene::RectShape{1, 0.5}, {3, 2, 1}, rotation_x(40) * scaling({1, 1e-9, 2}), {}},
                  {"b", scene::DiskShape{2}, {1, 1, 1}, scaling({1, -2, 3}), {}}};
  const auto lit = adapters::lights_as_meshes(scene);
  EXPECT_TRUE(lit.lights.empty());
  ASSERT_EQ(lit.meshes.size(), 4U);
  for (const std::size_t i : {0U, 2U}) {
    scene::Mesh both = lit.meshes[i];
    const auto first = vertex_count(both);
    both.positions.insert(both.positions.end(), lit.meshes[i + 1].positions.begin(),
                          lit.meshes[i + 1].positions.end());
    for (auto triangle : lit.meshes[i + 1].triangles) {
      for (auto& corner : triangle) corner += first;
      both.triangles.push_back(triangle);
    }
    EXPECT_TRUE(adapters::is_closed(both)) << i;
    EXPECT_TRUE(adapters::is_wound_outwards(both)) << i;
  }
}

TEST(LightsAsMeshes, AnEnvironmentIsABoxAroundAllThatIsDrawn) {
  scene::Scene scene = cubes({"m", scene::Lambert{}}, {translation({50, 0, 0})});
  scene.environment.radiance = {1, 2, 3};
  scene.lights = {{"lamp", scene::SphereShape{1}, {1, 1, 1}, translation({0, 80, 0}), {}}};
  const auto lit = adapters::lights_as_meshes(scene);
  EXPECT_EQ(lit.environment.radiance, scene::RgbColour{});
  const auto& box = *std::find_if(lit.instances.begin(), lit.instances.end(),
                                  [](const auto& instance) { return instance.name == "environment"; });
  const auto& model = material_at(lit, mesh_of(lit, box).triangle_materials.at(0)).model;
  EXPECT_EQ(std::get<scene::Emission>(model).radiance, scene.environment.radiance);
  for (const Vec3d inside : {Vec3d{0, 0, 9}, Vec3d{51, 1, 1}, Vec3d{0, 81, 0}})
    EXPECT_TRUE(adapters::encloses(mesh_of(lit, box), transform_point(inverse(box.matrix).value(), inside)));
}

}  // namespace

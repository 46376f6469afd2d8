// What is written for HydraCore3; tests/golden reads whole scenes back.
#include "adapters/hydra/hydra.h"

#include "adapters/export.h"
#include "adapters/hydra/ies.h"
#include "adapters/hydra/remap_lists.h"
#include "adapters/hydra/textures.h"
#include "adapters/job.h"
#include "base/files.h"
#include "base/text.h"
#include "image/image_io.h"
#include "registry/configuration.h"
#include "scene/geometry/generators.h"
#include "scene/load/load_scene.h"
#include "structure/source_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numbers>

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using adapters::hydra_limits;
using adapters::hydra_paths;
using structure::TestFolder;

scene::Scene suite_scene(const std::string& name) {
  return scene::load_scene(std::string(ORBS_SOURCE_DIR "/data/cases/orbs/") + name + ".json");
}

scene::Scene box_of(const scene::MaterialModel& model) {
  scene::Scene scene;
  scene.materials = {{"m", model}};
  scene.meshes = {scene::make_cube({1})};
  scene.meshes[0].triangle_materials.assign(12, 0);
  scene.instances = {{"i", 0, {}, {}}};
  return scene;
}

std::string exported(const scene::Scene& scene, const TestFolder& folder) {
  adapters::write_hydra(scene, {}, folder.path() / "hydra.xml");
  return read_file(folder.path() / "hydra.xml");
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(HydraPaths, ADepthIsTheScenesOrOneMoreByWhatFindsTheLight) {
  scene::Scene scene = box_of(scene::Lambert{});
  scene.environment.radiance = {1, 1, 1};
  scene.trace_depth = 4;
  EXPECT_EQ(hydra_paths(scene, {}).trace_depth, 5) << "the environment is found behind the last surface";
  EXPECT_EQ(hydra_paths(scene, {{"naive", 1}}).trace_depth, 4);
  scene.lights = {{"l", scene::DiskShape{1}, {1, 1, 1}, {}, {}}};
  EXPECT_EQ(hydra_paths(scene, {}).trace_depth, 5);
  scene.environment.radiance = {};
  EXPECT_EQ(hydra_paths(scene, {}).trace_depth, 4) << "lamps are sampled at the last surface";
  EXPECT_FALSE(hydra_paths(scene, {}).is_direct);
  scene.trace_depth = 1;
  EXPECT_EQ(hydra_paths(scene, {}).trace_depth, 2);
  EXPECT_TRUE(hydra_paths(scene, {}).is_direct);
  EXPECT_EQ(hydra_paths(scene, {{"naive", 1}}).trace_depth, 1);
  EXPECT_FALSE(hydra_paths(scene, {{"naive", 1}}).is_direct);
}

TEST(HydraPaths, TheCommandNamesTheLayer) {
  registry::Renderer renderer;
  renderer.format.name = "hydra";
  renderer.command.words = {"r", "{scene}", "{output}", "{layer}"};
  scene::Scene scene = box_of(scene::Lambert{});
  EXPECT_EQ(adapters::make_job(renderer, scene, {}, "/o").argv.back(), "color");
  scene.trace_depth = 1;
  EXPECT_EQ(adapters::make_job(renderer, scene, {}, "/o").argv.back(), "direct");
  renderer.format.settings = {{"naive", 1}};
  EXPECT_EQ(adapters::make_job(renderer, scene, {}, "/o").argv.back(), "color");
}

// It looks for meshes in the folder that stands before the last slash of its scene's path. Where images are
// rendered elsewhere there is none: every mesh was left out, and the images were black.
TEST(HydraCommand, NamesTheFolderOfTheMeshes) {
  const auto configuration = registry::load_configuration(ORBS_SOURCE_DIR "/configuration.json");
  int variants = 0;
  for (const auto& renderer : configuration.renderers) {
    if (renderer.format.name != "hydra") continue;
    ++variants;
    const auto argv = adapters::make_job(renderer, box_of(scene::Lambert{}), {}, "/o").argv;
    const auto option = std::find(argv.begin(), argv.end(), "-scn_dir");
    ASSERT_LT(option - argv.begin(), std::ssize(argv) - 1) << renderer.name;
    EXPECT_EQ(option[1], "/o");
  }
  EXPECT_EQ(variants, 3);
}

TEST(HydraRemapLists, AreSortedClosedAndWrittenOnce) {
  scene::Scene scene;
  scene.instances = {{"a", 0, {}, {}},
                     {"b", 0, {}, {{3, 1}, {0, 2}}},
                     {"c", 0, {}, {{0, 2}, {3, 1}, {0, 4}}},
                     {"d", 0, {}, {{7, 0}}}};
  const auto lists = adapters::hydra::remap_lists(scene, 7);
  EXPECT_EQ(lists.of_instances, (std::vector<int>{-1, 0, 0, 1}));
  EXPECT_EQ(lists.text,
            "<remap_lists>\n<remap_list id=\"0\" size=\"6\" val=\"0 2 3 1 7 7\"/>\n"
            "<remap_list id=\"1\" size=\"2\" val=\"7 0\"/>\n</remap_lists>\n");
  scene.instances.resize(1);
  EXPECT_EQ(adapters::hydra::remap_lists(scene, 7).text, "");
}

std::string written_texture(const image::Image& image, const std::string& name, const std::string& written) {
  const TestFolder folder("hydra-texture");
  if (name.ends_with(".png"))
    image::write_png(image, folder.path() / name);
  else
    image::write_exr(image, folder.path() / name);
  scene::Lambert lambert{{1, 1, 1}, scene::TextureUse{0, {}}};
  scene::Scene scene = box_of(lambert);
  scene.textures = {{"t", folder.path() / name, scene::Wrap::Clamp, scene::Wrap::Repeat}};
  const auto text = exported(scene, folder);
  EXPECT_TRUE(contains(text, "addressing_mode_u=\"clamp\" addressing_mode_v=\"wrap\"")) << text;
  EXPECT_TRUE(contains(text, "loc=\"" + written + "\" width=\"1\" height=\"2\"")) << text;
  EXPECT_TRUE(contains(text, name.ends_with(".png") ? "input_gamma=\"2.2\"" : "input_gamma=\"1\"")) << text;
  return read_file(folder.path() / written);
}

// The upper texel is red, the lower one a dark green.
image::Image two_texels() {
  auto image = image::make_image(1, 2, {"R", "G", "B"});
  image.at(0, 0, 0) = 1;
  image.at(0, 1, 1) = 51.0F / 255;
  return image;
}

TEST(HydraTextures, BytesStayBytesAndBeginWithTheBottomRow) {
  EXPECT_EQ(written_texture(two_texels(), "t.png", "hydra-texture0.image4ub"),
            std::string("\x01\0\0\0\x02\0\0\0"
                        "\0\x33\0\xff"
                        "\xff\0\0\xff",
                        16));
}

TEST(HydraTextures, FloatsStayFloats) {
  const auto bytes = written_texture(two_texels(), "t.exr", "hydra-texture0.image4f");
  ASSERT_EQ(bytes.size(), 8U + 2 * 16);
  std::array<float, 8> texels{};
  std::memcpy(texels.data(), bytes.data() + 8, sizeof texels);
  EXPECT_EQ(texels, (std::array<float, 8>{0, 51.0F / 255, 0, 1, 1, 0, 0, 1}));
}

// As tried with HydraCore3: with identities azimuth 0 is -X and 90 degrees +Z, its matrix acts on the
// direction in the world, and the transpose of the light's on the result.
double looked_up(const scene::IesUse& use, const Mat4& light, const Mat4& matrix, Vec3d direction) {
  const Vec3d turned = transform_direction(matrix, direction);
  const Vec3d local{dot(turned, transform_direction(light, {1, 0, 0})),
                    dot(turned, transform_direction(light, {0, 1, 0})),
                    dot(turned, transform_direction(light, {0, 0, 1}))};
  EXPECT_NEAR(length(local), 1, 1e-9);
  constexpr double kDegrees = 180 / std::numbers::pi;
  return candela_at(*use.profile, std::atan2(std::hypot(local.x, local.z), -local.y) * kDegrees,
                    std::atan2(local.z, -local.x) * kDegrees);
}

scene::IesProfile lopsided_profile() {
  return scene::parse_ies(
      "p",
      "IESNA:LM-63-2002\r\nTILT=NONE\r\n1 -1 2 3 4 1 2 0 0 0\r\n1 1 0\r\n0 60 180\r\n0 100 200 360\r\n"
      "10 5 1\r\n10 20 2\r\n10 3 4\r\n10 5 1\r\n");
}

TEST(HydraIes, TheMatrixTurnsTheProfileWithItsLight) {
  scene::IesUse use;
  use.profile = std::make_shared<const scene::IesProfile>(lopsided_profile());
  use.matrix = rotation_y(25) * rotation_x(70);
  for (const Mat4& light : {Mat4{}, translation({1, 2, 3}) * rotation_z(40) * rotation_x(-20),
                            rotation_x(35) * scaling({3, 3, 3}), rotation_z(15) * scaling({-2, 2, 2})}) {
    ASSERT_EQ(adapters::hydra::ies_limit(use, light), "");
    const Mat4 matrix = adapters::hydra::ies_matrix(use, light);
    const Mat4 back = inverse(light * use.matrix).value();
    for (const Vec3d d :
         {Vec3d{0.48, 0.6, 0.64}, Vec3d{-0.48, -0.6, 0.64}, Vec3d{0.6, 0, -0.8}, Vec3d{0, -1, 0}})
      EXPECT_NEAR(looked_up(use, light, matrix, d),
                  candela_towards(*use.profile, normalised(transform_direction(back, d))), 1e-9);
  }
  EXPECT_TRUE(contains(adapters::hydra::ies_limit(use, scaling({1, 2, 1})), "scaled unevenly"));
}

TEST(HydraIes, TheGridHoldsTheProfileInTheMiddlesOfItsCells) {
  const auto profile = lopsided_profile();
  const auto grid = adapters::hydra::ies_grid(profile);
  EXPECT_EQ(grid.text.find('\r'), std::string::npos);
  for (const auto& line : split(grid.text, '\n')) EXPECT_LE(line.size(), 130U);
  const auto read = scene::parse_ies("grid", grid.text);
  ASSERT_EQ(read.vertical_deg.size(), 360U);
  ASSERT_EQ(read.horizontal_deg.size(), 180U);
  for (const std::size_t h : {0U, 49U, 179U})
    for (const std::size_t v : {0U, 119U, 359U})
      EXPECT_NEAR(
          read.candela[h * 360 + v],
          candela_at(profile, 0.5 * (static_cast<double>(v) + 0.5), 2 * (static_cast<double>(h) + 0.5)) /
              profile.max_candela,
          1e-5);
  EXPECT_NEAR(grid.peak, 1, 0.02);
  EXPECT_LT(grid.peak, 1);
}

TEST(HydraLights, AreCalledByTheirMeshesAndTheSkyIsTheLast) {
  const TestFolder folder("hydra-lights");
  scene::Scene scene = box_of(scene::Lambert{{0.5, 0.5, 0.5}, {}});
  scene.environment.radiance = {0.25, 0.5, 1};
  scene.lights = {{"a", scene::RectShape{1, 2}, {3, 2, 1}, translation({0, 4, 0}), {}},
                  {"b", scene::SphereShape{0.5}, {1, 1, 1}, {}, {}}};
  const auto text = exported(scene, folder);
  for (
      const char* part :
      {"<size half_length=\"1\" half_width=\"2\"/><intensity><color val=\"3 2 1\"/><multiplier val=\"1\"/>",
       "<material id=\"1\" type=\"hydra_material\" light_id=\"0\"><emission><color val=\"3 2 1\"/>",
       "<instance id=\"1\" mesh_id=\"1\" rmap_id=\"-1\" matrix=\"1 0 0 0 0 1 0 4 0 0 1 0 0 0 0 1\" linst_id=\"0\"/>",
       "linst_id=\"1\"/>", "<light id=\"2\" type=\"sky\"", "<instance_light id=\"2\" light_id=\"2\""})
    EXPECT_TRUE(contains(text, part)) << part << "\n" << text;
}

TEST(HydraMaterials, ThatNoSurfaceShowsKeepTheirPlace) {
  const TestFolder folder("hydra-materials");
  scene::Scene scene = box_of(scene::RoughGlass{{1, 1, 1}, 1.5, 0.1});
  scene.materials.push_back({"shown", scene::OrenNayar{{0.5, 0.25, 1}, 0.7, {}}});
  scene.meshes[0].triangle_materials.assign(12, 1);
  EXPECT_TRUE(hydra_limits(scene).empty());
  const auto text = exported(scene, folder);
  EXPECT_TRUE(contains(
      text, "<material id=\"0\" type=\"diffuse\"><bsdf type=\"lambert\"/><reflectance val=\"0 0 0\"/>"))
      << text;
  EXPECT_TRUE(contains(text,
                       "<material id=\"1\" type=\"diffuse\"><bsdf type=\"oren-nayar\"/><roughness "
                       "val=\"0.7\"/><reflectance val=\"0.5 0.25 1\"/>"))
      << text;
}

void expect_limit(const scene::Scene& scene, const std::string& word) {
  const auto limits = hydra_limits(scene);
  ASSERT_EQ(limits.size(), 1U) << word;
  EXPECT_TRUE(contains(limits.front(), word)) << limits.front();
}

TEST(HydraLimits, WhatItCannotDrawIsRefusedWithAReason) {
  expect_limit(box_of(scene::Glass{{1, 0.9, 1}, 1.5}), "tinted glass");
  expect_limit(box_of(scene::RoughGlass{{1, 1, 1}, 1.5, 0.1}), "rough glass");
  expect_limit(box_of(scene::Ggx{{1, 1, 1}, 1e-4}), "alpha");
  expect_limit(box_of(scene::Conductor{}), "metals");
  scene::Scene scene = box_of(scene::Lambert{});
  scene.trace_depth = scene::kUnlimitedDepth;
  expect_limit(scene, "roulette");
  scene.trace_depth = 5;
  scene.lights = {{"l", scene::RectShape{1, 1}, {1, 1, 1}, {}, {}}};
  EXPECT_TRUE(hydra_limits(scene).empty());
  scene.lights[0].matrix(0, 2) = 0.1;
  expect_limit(scene, "sheared");
  scene.lights[0].matrix = scaling({2, 1, 3});
  EXPECT_TRUE(hydra_limits(scene).empty());
  scene.lights[0].reflectance = {0.5, 0.5, 0.5};
  EXPECT_FALSE(hydra_limits(scene).empty());
}

TEST(HydraLimits, ProfilesTexturedEmissionAndOrenNayarAreTaken) {
  for (const char* name : {"l4_light_ies/232", "m6_emission_texture/124", "m7_oren_nayar/100",
                           "a2_paths_basic/a2-glossy", "a3_paths_glass/a3-lamp-in-ball"})
    EXPECT_TRUE(hydra_limits(suite_scene(name)).empty())
        << name << ": " << hydra_limits(suite_scene(name)).front();
}

}  // namespace

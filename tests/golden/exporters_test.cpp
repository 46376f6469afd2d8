#include "adapters/hydra/hydra.h"
#include "adapters/mitsuba/mitsuba.h"
#include "adapters/pbrt/colours.h"
#include "adapters/pbrt/pbrt.h"
#include "base/files.h"
#include "golden/read_back.h"
#include "image/image_io.h"
#include "scene/geometry/generators.h"
#include "scene/geometry/ply.h"
#include "scene/load/load_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

/// None of these renderers is among Debian's packages, so what the exporters write is read back and compared
/// with the scene it came from, for all scenes of the suite that they take.
namespace {

using namespace orbs;
namespace fs = std::filesystem;

struct Format {
  std::string name;
  std::vector<std::string> (*limits)(const scene::Scene&);
  void (*write)(const scene::Scene&, const fs::path&);
  tests::ReadScene (*read)(const fs::path&);
};

const Format kMitsuba{"mitsuba", adapters::mitsuba_limits, adapters::write_mitsuba, tests::read_mitsuba};
const Format kPbrt{"pbrt", adapters::pbrt_limits, adapters::write_pbrt, tests::read_pbrt};

// Its integrator naivept counts scatterings as ours.
const Format kHydra{"hydra", [](const scene::Scene& scene) { return adapters::hydra_limits(scene); },
                    [](const scene::Scene& scene, const fs::path& file) {
                      adapters::write_hydra(scene, {{"naive", 1}}, file);
                    },
                    tests::read_hydra};

class Exported : public testing::TestWithParam<Format> {
 protected:
  tests::ReadScene read_back(const scene::Scene& scene) const {
    GetParam().write(scene, folder_ / "scene.txt");
    return GetParam().read(folder_ / "scene.txt");
  }
  ScratchFolder scratch_{"orbs-exported"};
  fs::path folder_ = scratch_.path();
};

INSTANTIATE_TEST_SUITE_P(Formats, Exported, testing::Values(kMitsuba, kPbrt, kHydra), [](const auto& format) {
  return format.param.name;
});

class ExportedForTwo : public Exported {};

INSTANTIATE_TEST_SUITE_P(Formats, ExportedForTwo, testing::Values(kMitsuba, kPbrt), [](const auto& format) {
  return format.param.name;
});

scene::Scene suite_scene(const std::string& name) {
  return scene::load_scene(fs::path(ORBS_SOURCE_DIR) / "data/cases/orbs" / (name + ".json"));
}

std::map<std::string, tests::Moments> moments_of(const scene::Scene& scene) {
  std::map<std::string, tests::Moments> out;
  for (const auto& [material, moments] : tests::moments_of_materials(scene))
    out[fmt::format("material{}", material)] = moments;
  return out;
}

void expect_near(Vec3d a, Vec3d b, double most, const std::string& what) {
  EXPECT_LE(length(a - b), most) << what << ": " << a.x << " " << a.y << " " << a.z << " instead of " << b.x
                                 << " " << b.y << " " << b.z;
}

void expect_same_surfaces(const scene::Scene& scene, const tests::ReadScene& read) {
  const auto expected = moments_of(scene);
  ASSERT_EQ(read.materials.size(), expected.size());
  for (const auto& [name, moments] : expected) {
    const tests::Moments& found = read.materials.at(name);
    const double most = 1e-5 * moments.area_m2;
    EXPECT_NEAR(found.area_m2, moments.area_m2, most) << name;
    expect_near(found.centre, moments.centre, 10 * most, name + " centre");
    EXPECT_NEAR(found.uv.x, moments.uv.x, 10 * most) << name;
    EXPECT_NEAR(found.uv.y, moments.uv.y, 10 * most) << name;
    // Emitters of Mitsuba show the normals of their faces, which need not be those of the vertices.
    if (!read.emission.contains(name)) expect_near(found.normal, moments.normal, most, name + " normal");
  }
}

void expect_same_camera(const scene::Scene& scene, const tests::ReadScene& read) {
  EXPECT_EQ(read.eye, scene.camera.position_m);
  EXPECT_EQ(read.target, scene.camera.look_at_m);
  EXPECT_EQ(read.up, scene.camera.up);
  EXPECT_NEAR(read.fov_y_deg, scene.camera.fov_y_deg, 1e-9);
  EXPECT_EQ(read.width_px, scene.camera.width_px);
  EXPECT_EQ(read.height_px, scene.camera.height_px);
  EXPECT_EQ(read.trace_depth, scene.trace_depth);
  expect_near(read.environment, scene.environment.radiance, 1e-6 * length(scene.environment.radiance),
              "environment");
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

void expect_same_lights(const scene::Scene& scene, const tests::ReadScene& read) {
  ASSERT_EQ(read.lights.size(), scene.lights.size());
  for (std::size_t i = 0; i < read.lights.size(); ++i) {
    const scene::Light& light = scene.lights[i];
    expect_near(read.lights[i].radiance, light.radiance, 1e-6 * length(light.radiance), "radiance");
    EXPECT_NEAR(read.lights[i].area_m2, area_m2(light), 1e-9 * area_m2(light));
    expect_near(read.lights[i].centre, transform_point(light.matrix, {}), 1e-12, "centre");
    if (std::holds_alternative<scene::SphereShape>(light.shape)) continue;
    const Vec3d down = normalised(transform_normal(inverse(light.matrix).value(), {0, -1, 0}));
    expect_near(read.lights[i].facing, down, 1e-9, "facing");
  }
}

TEST_P(Exported, SuiteScenesReadBackAsTheyWere) {
  const std::vector<std::string> taken{"a1_trace_depth/248-full",
                                       "g1_primitive_format/g1-attributes",
                                       "g2_single_mesh/g2-camera-wide",
                                       "g3_inst_matrices/g3-matrices",
                                       "g4_inst_change_material/g4-lambert",
                                       "g5_inst_remaplist/078",
                                       "g5_inst_remaplist/078-remap",
                                       "l1_area_light/246",
                                       "l2_sphere_light/201",
                                       "l3_light_matrices/215",
                                       "l3_light_matrices/224",
                                       "m2_emission/123-red",
                                       "m3_mirror/102",
                                       "m4_lambert_texture/103",
                                       "m5_texture_matrices/110",
                                       "m8_smooth_glass/113"};
  for (const std::string& name : taken) {
    SCOPED_TRACE(name);
    const scene::Scene scene = suite_scene(name);
    const auto limits = GetParam().limits(scene);
    ASSERT_TRUE(limits.empty()) << limits.front();
    const tests::ReadScene read = read_back(scene);
    expect_same_camera(scene, read);
    expect_same_lights(scene, read);
    expect_same_surfaces(scene, read);
  }
}

TEST_P(ExportedForTwo, WhatTheRendererLacksIsRefusedWithAReason) {
  for (const auto& [name, word] : std::map<std::string, std::string>{{"l4_light_ies/232", "IES"},
                                                                     {"m6_emission_texture/124", "texture"},
                                                                     {"m7_oren_nayar/100", "Lambert"}}) {
    const auto limits = GetParam().limits(suite_scene(name));
    ASSERT_FALSE(limits.empty()) << name;
    EXPECT_NE(limits.front().find(word), std::string::npos) << limits.front();
  }
}

TEST_P(Exported, UprightImageAndMirroredThingsReadBack) {
  scene::Scene scene;
  scene.camera.position_m = {1, 2, 9};
  scene.camera.fov_y_deg = 50;
  scene.camera.width_px = 30;
  scene.camera.height_px = 90;  // higher than wide: pbrt's angle is the other one
  scene.materials = {{"glow -- \"<x>\"\n&", scene::Emission{{1, 2, 3}, {}}},
                     {"grey", scene::Lambert{{0.5, 0.5, 0.5}, {}}}};
  for (const int material : {0, 1}) {
    scene::Mesh ball = scene::make_sphere({1, 16});
    ball.triangle_materials.assign(ball.triangles.size(), material);
    scene.meshes.push_back(ball);
  }
  const Mat4 mirror = translation({0, 3, 0}) * rotation_z(20) * scaling({-1, 2, 1});
  scene.instances = {{"a", 0, mirror, {}}, {"b", 1, translation({5, 0, 0}) * mirror, {}}, {"c", 1, {}, {}}};
  scene.lights = {{"l", scene::RectShape{1, 2}, {1, 1, 1}, scaling({1, -2, 1}), {}},
                  {"d", scene::DiskShape{2}, {3, 2, 1}, rotation_x(30) * scaling({-2, 1, 2}), {}}};
  ASSERT_TRUE(GetParam().limits(scene).empty());
  const tests::ReadScene read = read_back(scene);
  expect_same_camera(scene, read);
  expect_same_lights(scene, read);
  expect_same_surfaces(scene, read);
  expect_near(read.emission.at("material0"), {1, 2, 3}, 1e-5, "emission");
}

TEST_P(Exported, SameSceneGivesTheSameText) {
  const scene::Scene scene = suite_scene("l3_light_matrices/215");
  GetParam().write(scene, folder_ / "scene.txt");
  const std::string first = read_file(folder_ / "scene.txt");
  GetParam().write(scene, folder_ / "scene.txt");
  EXPECT_EQ(first, read_file(folder_ / "scene.txt"));
}

TEST_P(ExportedForTwo, TexturesAreLinearImagesWithTheColourMultipliedIn) {
  scene::Scene scene = suite_scene("m4_lambert_texture/103");
  read_back(scene);
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const auto* lambert = std::get_if<scene::Lambert>(&scene.materials[i].model);
    if (lambert == nullptr || lambert->reflectance.x != 0.95) continue;  // red times a checker with white
    const bool is_split = GetParam().name == "pbrt";  // into an image for each of R, G and B
    const auto texel = [&](int x, int y, std::size_t c) {
      const char* const channel[]{"-r", "-g", "-b"};
      const auto image =
          image::read_image(folder_ / fmt::format("scene-material{}{}.exr", i, is_split ? channel[c] : ""));
      return image.at(x, y < 0 ? image.height - 1 : y, is_split ? 0 : c);
    };
    EXPECT_EQ(texel(0, -1, 0), 0.95F);
    EXPECT_EQ(texel(0, -1, 1), 0.05F);
    EXPECT_EQ(texel(0, 0, 0), 0.0F);  // the upper left field is black
    return;
  }
  FAIL() << "no red material";
}

class MitsubaEmission : public testing::Test {
 protected:
  ScratchFolder scratch_{"orbs-mitsuba-emission"};
};

// The back of Mitsuba's emitters is dark: nobody sees it on a closed mesh from outside.
TEST(MitsubaLimits, EmissionNeedsAClosedMeshSeenFromOutside) {
  scene::Scene scene;
  scene.materials = {{"glow", scene::Emission{{1, 1, 1}, {}}}, {"grey", scene::Lambert{{0.5, 0.5, 0.5}, {}}}};
  scene.meshes = {scene::make_cube({1}), scene::make_cube({1})};
  scene.meshes[0].triangle_materials.assign(12, 0);
  scene.meshes[1].triangle_materials.assign(12, 1);
  scene.instances = {{"i", 0, scaling({2, 2, 2}), {}}, {"lit", 1, translation({9, 0, 0}), {}}};
  scene.camera.position_m = {0, 0, 2.1};
  EXPECT_TRUE(adapters::mitsuba_limits(scene).empty());
  scene.camera.position_m = {0, 0, 1.9};
  EXPECT_EQ(adapters::mitsuba_limits(scene).size(), 1U);
  EXPECT_TRUE(adapters::pbrt_limits(scene).empty());
  scene.camera.position_m = {0, 0, 2.1};
  scene.meshes[0].triangles.pop_back();
  scene.meshes[0].triangle_materials.pop_back();
  EXPECT_EQ(adapters::mitsuba_limits(scene).size(), 1U);
}

// As in an id pass: the winding that the camera sees is right, whatever the mesh.
TEST_F(MitsubaEmission, OfAnOpenMeshFacesTheCameraThatAloneSeesIt) {
  scene::Scene scene;
  scene.materials = {{"glow", scene::Emission{{1, 1, 1}, {}}}};
  scene.meshes = {scene::make_cube({1})};
  scene.meshes[0].triangle_materials.assign(12, 0);
  scene.meshes[0].triangles.pop_back();
  scene.meshes[0].triangle_materials.pop_back();
  const Mat4 mirror = scaling({-1, 1, 1});
  scene.instances = {{"i", 0, mirror, {}}};
  scene.camera.position_m = {0.3, 0.2, 9};
  ASSERT_TRUE(adapters::mitsuba_limits(scene).empty());
  for (const Vec3d eye : {Vec3d{0.3, 0.2, 9}, Vec3d{0.1, 0.2, 0.3}}) {
    scene.camera.position_m = eye;
    adapters::write_mitsuba(scene, scratch_.path() / "scene.xml");
    const auto mesh = scene::read_ply(scratch_.path() / "scene-mesh0.0.ply").mesh;
    ASSERT_EQ(mesh.triangles.size(), 11U);
    for (const auto& t : mesh.triangles) {
      const auto corner = [&](std::size_t i) {
        return transform_point(mirror, cast<double>(mesh.positions[t[i]]));
      };
      EXPECT_GT(dot(cross(corner(1) - corner(0), corner(2) - corner(0)), eye - corner(0)), 0);
    }
  }
}

TEST(ExporterLimits, MaskingOfAnotherFormIsTakenWhereItCannotBeSeen) {
  scene::Scene scene = suite_scene("a4_paths_glossy_glass/a4-ball");
  EXPECT_TRUE(adapters::mitsuba_limits(scene).empty());
  EXPECT_TRUE(adapters::pbrt_limits(scene).empty());
  for (scene::Material& material : scene.materials)
    if (auto* glass = std::get_if<scene::RoughGlass>(&material.model)) glass->alpha = 0.3;
  EXPECT_EQ(adapters::mitsuba_limits(scene).size(), 1U);
  EXPECT_EQ(adapters::pbrt_limits(scene).size(), 1U);
}

// pbrt's film has three buckets, and each colour one step in each of them: nothing passes between R, G and B.
TEST(PbrtBands, AColourIsThreeStepsWithTheirEdgesBetweenWholeNanometres) {
  EXPECT_EQ(adapters::pbrt::band_spectrum("L", {3, 2, 1}),
            "\"spectrum L\" [360 1 499.4999 1 499.5 2 599.4999 2 599.5 3 830 3]");
  EXPECT_EQ(adapters::pbrt::band_channels(),
            (std::array<std::string, 3>{"S0.649,500nm", "S0.549,500nm", "S0.449,500nm"}));
}

// A spectrum without luminance cannot be scaled to the light's: pbrt would divide by zero.
TEST(PbrtBands, BlackLightIsAScaleOfZero) {
  EXPECT_TRUE(adapters::pbrt::band_emission("L", {}).ends_with("\"float scale\" 0"));
  EXPECT_EQ(adapters::pbrt::band_emission("L", {}).find("[360 0"), std::string::npos);
}

// The prism is lit by a square of 2 cm, 21 m away.
TEST(PbrtLimits, ALightBehindSmoothGlassMustFillSomeSolidAngle) {
  const auto limits = adapters::pbrt_limits(
      scene::load_scene(ORBS_SOURCE_DIR "/data/cases/appearance/e6_dispersion/prism_achromatic.json"));
  ASSERT_EQ(limits.size(), 1U);
  EXPECT_TRUE(limits.front().starts_with("light 'lamp' fills 9.3e-07 sr as seen from mesh 'prism'"))
      << limits.front();
}

TEST(PbrtLimits, ColourOfMirrorsAndGlassIsRefused) {
  scene::Scene scene = suite_scene("m8_smooth_glass/113");
  EXPECT_TRUE(adapters::pbrt_limits(scene).empty());
  for (scene::Material& material : scene.materials)
    if (auto* glass = std::get_if<scene::Glass>(&material.model)) {
      glass->colour = {1, 0.9, 1};
      break;
    }
  EXPECT_EQ(adapters::pbrt_limits(scene).size(), 1U);
  scene = suite_scene("m3_mirror/102");
  for (scene::Material& material : scene.materials)
    if (auto* mirror = std::get_if<scene::Mirror>(&material.model)) mirror->reflectance = {0.9, 0.5, 0.1};
  EXPECT_FALSE(adapters::pbrt_limits(scene).empty());
  EXPECT_TRUE(adapters::mitsuba_limits(scene).empty());
}

}  // namespace

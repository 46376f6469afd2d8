#include "scene/lower/lower.h"

#include "scene/lower/geometry.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <gtest/gtest.h>

using namespace orbs;
using namespace orbs::scene;

namespace {

const Capabilities kAll{"G1", "G2", "G3", "G4", "G5", "M1", "M2", "M3", "M4", "M5", "M6",
                        "M7", "M8", "L1", "L2", "L3", "L4", "A1", "A2", "A3", "A4"};

Capabilities without(const std::set<std::string>& codes) {
  auto rest = kAll;
  for (const auto& code : codes) rest.erase(code);
  return rest;
}

// One triangle in front of the camera, with material 0.
Scene triangle_with(MaterialModel model) {
  Scene scene;
  scene.materials.push_back({"m", std::move(model)});
  Mesh mesh;
  mesh.name = "t";
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.normals.assign(3, {0, 0, 1});
  mesh.tangents.assign(3, {});
  mesh.uvs = {{0, 0}, {1, 0}, {0, 1}};
  mesh.triangles = {{0, 1, 2}};
  mesh.triangle_materials = {0};
  scene.meshes.push_back(mesh);
  scene.instances.push_back({"t", 0, {}, {}});
  scene.textures.push_back({"t", "/t.png"});
  return scene;
}

Scene scene_with(Light light) {
  auto scene = triangle_with(Lambert{});
  light.name = "l";
  scene.lights.push_back(std::move(light));
  return scene;
}

std::string reason_of(const Scene& scene, const std::set<std::string>& missing) {
  const auto lowered = lower(scene, without(missing));
  const auto* reason = std::get_if<std::string>(&lowered);
  return reason == nullptr ? "lowered" : *reason;
}

Light lowered_light(const LightShape& shape, const Mat4& matrix) {
  const auto lowered = lower(scene_with({"", shape, {1, 1, 1}, matrix, {}}), without({"L3"}));
  EXPECT_TRUE(std::holds_alternative<Scene>(lowered)) << std::get<std::string>(lowered);
  return std::get<Scene>(lowered).lights.at(0);
}

std::string light_reason(const LightShape& shape, const Mat4& matrix) {
  return reason_of(scene_with({"", shape, {1, 1, 1}, matrix, {}}), {"L3"});
}

const std::string kNeedsL3 =
    "light 'l' is turned or scaled in a way that its sizes cannot take up, which needs L3";

}  // namespace

TEST(LowerMaterials, EachModelNeedsItsRequirement) {
  EXPECT_EQ(reason_of(triangle_with(Lambert{}), {"M1"}), "material 'm' is Lambertian, which needs M1");
  EXPECT_EQ(reason_of(triangle_with(Emission{}), {"M2"}), "material 'm' is emissive, which needs M2");
  EXPECT_EQ(reason_of(triangle_with(Mirror{}), {"M3"}), "material 'm' is a mirror, which needs M3");
  EXPECT_EQ(reason_of(triangle_with(Lambert{{}, TextureUse{}}), {"M4"}),
            "material 'm' has a texture, which needs M4");
  auto special = triangle_with(Lambert{{}, TextureUse{}});
  special.textures[0].wrap_v = Wrap::Mirror;
  EXPECT_EQ(reason_of(special, {"N4"}), "material 'm' has a mirrored texture, which needs N4");
  special.textures[0] = {"t", "/t.png", Wrap::Repeat, Wrap::Clamp, Filter::Nearest};
  EXPECT_EQ(reason_of(special, {"N5"}),
            "material 'm' has a texture that is not interpolated, which needs N5");
  auto hidden = triangle_with(Lambert{});
  hidden.environment.visible_to_camera = false;
  EXPECT_EQ(reason_of(hidden, {"D6"}), "the camera does not see the environment, which needs D6");
  auto layered = triangle_with(Lambert{});
  layered.outputs.layers = {"depth"};
  EXPECT_EQ(reason_of(layered, {"V1"}), "the image holds the layer 'depth', which needs V1");
  EXPECT_EQ(reason_of(triangle_with(Emission{{}, TextureUse{}}), {"M6"}),
            "material 'm' has a texture, which needs M6");
  EXPECT_EQ(reason_of(triangle_with(OrenNayar{{}, 0.5, {}}), {"M7"}),
            "material 'm' is Oren-Nayar, which needs M7");
  EXPECT_EQ(reason_of(triangle_with(Glass{}), {"M8"}), "material 'm' is smooth glass, which needs M8");
  EXPECT_EQ(reason_of(triangle_with(Ggx{}), {"A2"}),
            "material 'm' is a glossy reflector (GGX), which needs A2");
  EXPECT_EQ(reason_of(triangle_with(RoughGlass{}), {"A4"}), "material 'm' is rough glass, which needs A4");
}

TEST(LowerMaterials, WhatNoInstanceShowsNeedsNothing) {
  auto scene = triangle_with(Lambert{});
  scene.materials.push_back({"unused", Glass{}});
  EXPECT_EQ(reason_of(scene, {"M8"}), "lowered");
  scene.instances[0].remap = {{0, 1}};
  EXPECT_EQ(reason_of(scene, {"M8"}), "material 'unused' is smooth glass, which needs M8");
}

// ORB.S eq. 5 with sigma 0 is A = 1 and B = 0: Lambert's law.
TEST(LowerMaterials, SmoothOrenNayarIsLambert) {
  const auto lowered = lower(triangle_with(OrenNayar{{0.25, 0.5, 0.75}, 0, {}}), without({"M7"}));
  const auto& model = std::get<Lambert>(std::get<Scene>(lowered).materials[0].model);
  EXPECT_EQ(model.reflectance, (Vec3d{0.25, 0.5, 0.75}));
}

// E1 is about n and k and about roughness: a smooth dielectric is the smooth glass of M8 in other words.
TEST(LowerMaterials, ASmoothDielectricWithoutDispersionIsGlassOfTheSameRatio) {
  const auto lowered =
      lower(triangle_with(Dielectric{spectra::constant(1.5), spectra::constant(1.2), {}, {}}), kAll);
  ASSERT_TRUE(std::holds_alternative<Scene>(lowered)) << std::get<std::string>(lowered);
  EXPECT_EQ(std::get<Scene>(lowered).materials[0].model, (MaterialModel{Glass{{1, 1, 1}, 1.5 / 1.2}}));
  auto with_e1 = kAll;
  with_e1.insert("E1");
  const auto kept =
      lower(triangle_with(Dielectric{spectra::constant(1.5), spectra::constant(1), {}, {}}), with_e1);
  EXPECT_TRUE(std::holds_alternative<Dielectric>(std::get<Scene>(kept).materials[0].model));
}

TEST(LowerMaterials, ADielectricThatDispersesNeedsE6AndARoughOneE1) {
  const Scene prism =
      triangle_with(Dielectric{spectra::Cauchy{1.5, 0.01, 0, 0}, spectra::constant(1), {}, {}});
  EXPECT_NE(reason_of(prism, {}).find("which needs E6"), std::string::npos) << reason_of(prism, {});
  auto with_e6 = kAll;
  with_e6.insert("E6");
  const auto lowered = lower(prism, with_e6);
  ASSERT_TRUE(std::holds_alternative<Scene>(lowered)) << std::get<std::string>(lowered);
  EXPECT_EQ(std::get<Scene>(lowered).materials[0].model, prism.materials[0].model);
  EXPECT_EQ(
      reason_of(triangle_with(Dielectric{spectra::constant(1.5), spectra::constant(1), Roughness{}, {}}), {}),
      "material 'm' is a dielectric by its indices, which needs E1");
}

TEST(LowerMaterials, TextureMatricesGoIntoTheCoordinates) {
  const Mat4 matrix = translation({-0.5, 0.25, 0}) * scaling({2, 4, 1});
  const auto lowered = lower(triangle_with(Lambert{{}, TextureUse{0, matrix}}), without({"M5"}));
  const auto& scene = std::get<Scene>(lowered);
  EXPECT_EQ(texture_of(scene.materials[0].model)->matrix, Mat4{});
  EXPECT_EQ(scene.meshes[0].uvs, (std::vector<Vec2f>{{-0.5F, 0.25F}, {1.5F, 0.25F}, {-0.5F, 4.25F}}));
}

// Two triangles share an edge; only one has a texture matrix.
TEST(LowerMaterials, SharedVerticesGetTheirOwnCoordinatesForEachMaterial) {
  auto scene = triangle_with(Lambert{{}, TextureUse{0, scaling({2, 2, 1})}});
  scene.materials.push_back({"plain", Lambert{{}, TextureUse{}}});
  auto& mesh = scene.meshes[0];
  mesh.positions.push_back({1, 1, 0});
  mesh.normals.push_back({0, 0, 1});
  mesh.tangents.push_back({});
  mesh.uvs.push_back({1, 1});
  mesh.triangles.push_back({1, 3, 2});
  mesh.triangle_materials.push_back(1);
  const auto lowered = lower(scene, without({"M5"}));
  const auto& out = std::get<Scene>(lowered).meshes[0];
  ASSERT_EQ(out.positions.size(), 6U);
  EXPECT_EQ(out.uvs[out.triangles[0][1]], (Vec2f{2, 0}));
  EXPECT_EQ(out.uvs[out.triangles[1][0]], (Vec2f{1, 0}));
  EXPECT_EQ(out.positions[out.triangles[0][1]], out.positions[out.triangles[1][0]]);
}

TEST(LowerLights, ShapesAndProfilesNeedTheirRequirement) {
  EXPECT_EQ(reason_of(scene_with({"", RectShape{}, {}, {}, {}}), {"L1"}),
            "light 'l' is an area light, which needs L1");
  EXPECT_EQ(reason_of(scene_with({"", SphereShape{}, {}, {}, {}}), {"L2"}),
            "light 'l' is a sphere, which needs L2");
  EXPECT_EQ(reason_of(scene_with({"", RectShape{}, {}, {}, IesUse{}}), {"L4"}),
            "light 'l' has an IES profile, which needs L4");
}

TEST(LowerLights, ScaleGoesIntoTheSizesAndTheTranslationStays) {
  const auto light = lowered_light(RectShape{0.5, 0.25}, translation({1, 2, 3}) * scaling({2, 5, 4}));
  EXPECT_EQ(std::get<RectShape>(light.shape).half_width_m, 1.0);
  EXPECT_EQ(std::get<RectShape>(light.shape).half_length_m, 1.0);
  EXPECT_EQ(light.matrix, translation({1, 2, 3}));
  EXPECT_EQ(light.radiance, (Vec3d{1, 1, 1}));  // screen brightness does not change (REQ_L3)
}

TEST(LowerLights, AQuarterTurnAboutTheAxisSwapsTheSizesOfARectangle) {
  const auto light = lowered_light(RectShape{0.5, 0.25}, rotation_y(90));
  EXPECT_NEAR(std::get<RectShape>(light.shape).half_width_m, 0.25, 1e-15);
  EXPECT_NEAR(std::get<RectShape>(light.shape).half_length_m, 0.5, 1e-15);
}

TEST(LowerLights, ADiskMayTurnAboutItsAxis) {
  EXPECT_NEAR(
      std::get<DiskShape>(lowered_light(DiskShape{0.5}, rotation_y(37) * scaling({2, 1, 2})).shape).radius_m,
      1.0, 1e-15);
}

TEST(LowerLights, ASphereLosesItsRotation) {
  EXPECT_NEAR(std::get<SphereShape>(
                  lowered_light(SphereShape{0.5}, rotation_x(20) * rotation_y(37) * scaling({3, 3, 3})).shape)
                  .radius_m,
              1.5, 1e-14);
}

TEST(LowerLights, WhatTheSizesCannotTakeUpNeedsL3) {
  EXPECT_EQ(light_reason(RectShape{}, rotation_x(20)), kNeedsL3);
  EXPECT_EQ(light_reason(RectShape{}, rotation_y(20)), kNeedsL3);
  EXPECT_EQ(light_reason(RectShape{}, rotation_x(180)), kNeedsL3);  // would shine upwards
  EXPECT_EQ(light_reason(DiskShape{}, rotation_z(1)), kNeedsL3);
  EXPECT_EQ(light_reason(DiskShape{}, scaling({1, 1, 2})), kNeedsL3);
  EXPECT_EQ(light_reason(DiskShape{}, scaling({1, -1, 1})), kNeedsL3);
}

TEST(LowerLights, ASphereThatIsScaledUnevenlyIsBeyondEveryLevel) {
  EXPECT_EQ(reason_of(scene_with({"", SphereShape{}, {}, scaling({1, 2, 1}), {}}), {}),
            "light 'l' is a sphere with a scale that is not uniform, which no level of ORB.S has");
}

TEST(LowerLights, AProfileThatTurnsWithItsLightNeedsL3) {
  const Light turned{"", SphereShape{}, {}, rotation_y(30), IesUse{}};
  EXPECT_EQ(reason_of(scene_with(turned), {"L3"}), kNeedsL3);
  const Light scaled{"", SphereShape{}, {}, scaling({2, 2, 2}), IesUse{}};
  EXPECT_EQ(reason_of(scene_with(scaled), {"L3"}), "lowered");
}

// A profile that is turned over or mirrored is another one, whatever becomes of the shape.
TEST(Lower, AMirroredProfileNeedsTheMatrixOfItsLight) {
  Light light{"", SphereShape{1}, {1, 1, 1}, scaling({2, 2, 2}), IesUse{}};
  EXPECT_EQ(reason_of(scene_with(light), {"L3"}), "lowered");
  for (const Vec3d turned : {Vec3d{1, -1, 1}, Vec3d{1, 1, -1}, Vec3d{1, -1, -1}}) {
    light.matrix = scaling(turned);
    EXPECT_NE(reason_of(scene_with(light), {"L3"}), "lowered");
  }
}

TEST(CalledFeatures, AreNamedWithWhatCallsForThem) {
  auto scene = triangle_with(Ggx{});
  scene.materials.push_back({"n", Glass{}});
  scene.instances.push_back({"u", 0, translation({1, 0, 0}), {{0, 1}}});
  scene.lights.push_back({"s", SphereShape{}, {}, translation({0, 9, 0}), {}});
  std::map<std::string, std::string> found;
  for (const auto& feature : features_called_for(scene)) found[feature.requirement] = feature.what;
  EXPECT_EQ(found, (std::map<std::string, std::string>{{"A2", "material 'm' is a glossy reflector (GGX)"},
                                                       {"G1", "the scene is made of triangles"},
                                                       {"G2", "the scene has a camera"},
                                                       {"G3", "mesh 't' appears several times"},
                                                       {"G4", "instance 'u' changes materials of mesh 't'"},
                                                       {"L2", "light 's' is a sphere"},
                                                       {"M8", "material 'n' is smooth glass"}}));
}

TEST(Lowering, ALightWithoutANameIsCalledByItsPlace) {
  auto scene = scene_with({"", RectShape{1, 1}, {1, 1, 1}, {}, {}});
  scene.lights.push_back({"", SphereShape{1}, {1, 1, 1}, scaling({1, 2, 1}), {}});
  scene.lights[0].name = "l";
  EXPECT_EQ(reason_of(scene, {"L1"}),
            "light 1 is a sphere with a scale that is not uniform, which no level of ORB.S has");
  scene.lights[0].name = "";
  scene.lights.pop_back();
  EXPECT_EQ(reason_of(scene, {"L1"}), "light 0 is an area light, which needs L1");
}

// v of a sphere runs from 0 at the south pole to 1, and so must that of the mesh in its place: a texture on
// it would have half as many rows.
TEST(LowerShapes, AMeshInThePlaceOfASphereHasItsTextureCoordinates) {
  Scene scene;
  scene.materials = {{"m", Lambert{}}};
  scene.spheres = {{"ball", {1, 2, 3}, 2, 0}};
  tessellate_spheres(scene);
  const auto& mesh = scene.meshes.at(0);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3f p = mesh.positions[i];
    EXPECT_NEAR(mesh.uvs[i].y,
                0.5 + std::asin(std::clamp(static_cast<double>(p.y), -1.0, 1.0)) / std::numbers::pi, 1e-3);
    if (std::abs(p.y) > 0.99F || mesh.uvs[i].x > 0.99F) continue;
    const double u = std::atan2(p.x, p.z) / (2 * std::numbers::pi);
    EXPECT_NEAR(mesh.uvs[i].x, u < -1e-6 ? u + 1 : u, 1e-5);
  }
}

// What the exporters write of the materials of group B; that the programs make the right images of it shows
// in the suite everyday.
#include "unit/adapters/exported_text.h"

namespace {

using namespace orbs;
using tests::cube_of;

class EverydayMaterials : public tests::ExportedText {};

scene::Plastic plastic(bool is_nonlinear, std::optional<double> alpha = {}) {
  return {{0.5, 0.4, 0.3}, {}, 1.7, is_nonlinear, alpha};
}

}  // namespace

TEST_F(EverydayMaterials, PlasticHasAVacuumOutside) {
  const auto smooth = cube_of(plastic(true));
  EXPECT_HOLDS(
      mitsuba(smooth),
      R"(<bsdf type="plastic"><float name="int_ior" value="1.7"/><float name="ext_ior" value="1"/><boolean name="nonlinear" value="true"/><rgb name="diffuse_reflectance" value="0.5, 0.4, 0.3"/>)");
  EXPECT_HOLDS(hydra(smooth),
               R"(<int_ior val="1.7"/><ext_ior val="1"/><alpha val="0.0001"/><nonlinear val="1"/>)");
  EXPECT_HOLDS(pbrt(smooth), R"("string type" "coateddiffuse")");
  EXPECT_HOLDS(pbrt(smooth), R"("float eta" 1.7 "float roughness" 0)");
  const auto rough = cube_of(plastic(false, 0.2));
  EXPECT_HOLDS(mitsuba(rough), R"(<bsdf type="roughplastic">)");
  EXPECT_HOLDS(mitsuba(rough),
               R"(<boolean name="nonlinear" value="false"/><string name="distribution" value="ggx"/>)");
  EXPECT_HOLDS(hydra(rough), R"(<alpha val="0.2"/><nonlinear val="0"/>)");
}

TEST_F(EverydayMaterials, PlasticThatAProgramLacksIsRefused) {
  EXPECT_EQ(adapters::pbrt_limits(cube_of(plastic(false))).size(), 1U);
  EXPECT_EQ(adapters::pbrt_limits(cube_of(plastic(true))).size(), 0U);
  EXPECT_EQ(adapters::pbrt_limits(cube_of(plastic(true, 0.2))).size(), 1U);
  EXPECT_EQ(adapters::povray_limits(cube_of(plastic(true)), {}).size(), 1U);
  EXPECT_EQ(adapters::mitsuba_limits(cube_of(plastic(true, 0.2))).size(), 0U);
}

TEST_F(EverydayMaterials, BrushedMetalHasTwoRoughnesses) {
  const scene::AnisotropicGgx brushed{{0.5, 0.5, 0.5}, 0.1, 0.3, 90, scene::Masking::Separable};
  EXPECT_HOLDS(mitsuba(cube_of(brushed)),
               R"(<float name="alpha_u" value="0.3"/><float name="alpha_v" value="0.1"/>)");
  auto correlated = brushed;
  correlated.masking = scene::Masking::Correlated;
  correlated.rotation_deg = -180;
  EXPECT_HOLDS(pbrt(cube_of(correlated)), R"("float uroughness" 0.1 "float vroughness" 0.3)");
  EXPECT_EQ(adapters::pbrt_limits(cube_of(brushed)).size(), 1U) << "masking";
  EXPECT_EQ(adapters::mitsuba_limits(cube_of(correlated)).size(), 1U) << "masking";
  auto turned = brushed;
  turned.rotation_deg = 30;
  EXPECT_EQ(adapters::mitsuba_limits(cube_of(turned)).size(), 1U);
}

// 0.6 and 0.2 at most: a quarter shows Lambert's law, each part scaled to 0.8.
TEST_F(EverydayMaterials, MixesAreWeightedMeans) {
  const scene::GgxLambert mix{{0.6, 0.6, 0.6}, 0.1, {0.2, 0.1, 0.1}, scene::Mix::Maximum};
  EXPECT_HOLDS(mitsuba(cube_of(mix)), R"(<bsdf type="blendbsdf"><float name="weight" value="0.25"/>)");
  EXPECT_HOLDS(pbrt(cube_of(mix)), R"(["material0-glossy" "material0-diffuse"] "float amount" 0.25)");
  const scene::GgxLambert unlike{{0.8, 0.1, 0.1}, 0.1, {0.1, 0.8, 0.8}, scene::Mix::PerComponent};
  EXPECT_EQ(adapters::mitsuba_limits(cube_of(unlike)).size(), 1U);
}

TEST_F(EverydayMaterials, BlendsNameTheirParts) {
  auto scene = cube_of(scene::Lambert{{0.5, 0.5, 0.5}, {}});
  scene.materials.push_back({"g", scene::Ggx{{1, 1, 1}, 0.1}});
  scene.materials.push_back({"b", scene::Blend{{{{"m", 0}, {"g", 1}}}, 0.25, {}}});
  for (int& material : scene.meshes[0].triangle_materials) material = 2;
  EXPECT_EQ(scene::visible_materials(scene), (std::set<int>{0, 1, 2}));
  EXPECT_HOLDS(
      mitsuba(scene),
      R"(<bsdf type="blendbsdf" id="material2"><float name="weight" value="0.25"/><ref id="material0"/><ref id="material1"/></bsdf>)");
  EXPECT_HOLDS(pbrt(scene), R"("string materials" ["material0" "material1"] "float amount" 0.25)");
  EXPECT_HOLDS(hydra(scene), R"(<weight val="0.25"></weight><bsdf_1 id="0"/><bsdf_2 id="1"/>)");
}

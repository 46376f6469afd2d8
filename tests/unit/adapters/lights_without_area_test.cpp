// What the exporters write of points, spots and directional light; that the programs make the right images of
// it shows in the suite everyday.
#include "adapters/lights_as_meshes.h"
#include "adapters/obj/obj.h"
#include "adapters/pbrt/profile_image.h"
#include "json/document.h"
#include "unit/adapters/exported_text.h"

#include <numbers>

#include <gtest/gtest.h>

namespace {

using namespace orbs;
namespace fs = std::filesystem;

constexpr double kPi = std::numbers::pi;

scene::Scene lit_by(const scene::LightShape& shape, const Mat4& matrix = translation({1, 2, 3})) {
  auto scene = tests::cube_of(scene::Lambert{{0.5, 0.5, 0.5}, {}});
  scene.lights = {{"l", shape, {3, 2, 1}, matrix, {}}};
  return scene;
}

class LightsWithoutArea : public tests::ExportedText {};

TEST_F(LightsWithoutArea, PointsHaveTheirIntensity) {
  const auto scene = lit_by(scene::PointShape{});
  EXPECT_HOLDS(
      mitsuba(scene),
      R"(<emitter type="point"><point name="position" x="1" y="2" z="3"/><rgb name="intensity" value="3, 2, 1"/>)");
  EXPECT_HOLDS(pbrt(scene), R"(LightSource "point" "point3 from" [1 2 3] "spectrum I")");
  EXPECT_HOLDS(hydra(scene), R"(type="point" shape="point" distribution="uniform")");
  EXPECT_HOLDS(gltf(scene), R"("type": "point")");
  EXPECT_HOLDS(gltf(scene), "KHR_lights_punctual");
  // 2 C f^2 / d^2 = I / (pi d^2).
  EXPECT_HOLDS(povray(scene), fmt::format("fade_distance {} fade_power 2", 1e-4));
  EXPECT_HOLDS(povray(scene),
               fmt::format("{},{},{}", 3 / (2 * kPi * 1e-8), 2 / (2 * kPi * 1e-8), 1 / (2 * kPi * 1e-8)));
}

TEST_F(LightsWithoutArea, SpotsHaveHalfOrFullAnglesAsEachProgramCountsThem) {
  const auto scene = lit_by(scene::SpotShape{15, 30}, rotation_z(90));  // along +x
  EXPECT_HOLDS(pbrt(scene), R"("float coneangle" 30 "float conedeltaangle" 15)");
  EXPECT_HOLDS(povray(scene), "spotlight radius 15 falloff 30 tightness 0");
  EXPECT_HOLDS(hydra(scene), R"(<falloff_angle val="60"/><falloff_angle2 val="30"/>)");
  EXPECT_EQ(adapters::mitsuba_limits(scene).size(), 1U);
  EXPECT_EQ(adapters::gltf_limits(scene).size(), 1U);
  const auto hard = lit_by(scene::SpotShape{20, 20});
  EXPECT_TRUE(adapters::mitsuba_limits(hard).empty());
  EXPECT_HOLDS(pbrt(hard), R"("float coneangle" 20.02 "float conedeltaangle" 0.04)");
}

TEST_F(LightsWithoutArea, DirectionalLightShinesAlongItsLocalMinusY) {
  const auto scene = lit_by(scene::DirectionalShape{}, translation({5, 6, 7}) * scaling({2, 2, 2}));
  EXPECT_HOLDS(mitsuba(scene), R"(<vector name="direction" x="0" y="-1" z="0"/><rgb name="irradiance")");
  EXPECT_HOLDS(pbrt(scene),
               R"(LightSource "distant" "point3 from" [0 0 0] "point3 to" [0 -1 0] "spectrum L")");
  EXPECT_HOLDS(povray(scene), "parallel point_at");
  EXPECT_HOLDS(povray(scene), fmt::format("{},{},{}", 3 / kPi, 2 / kPi, 1 / kPi));
  EXPECT_HOLDS(hydra(scene), R"(type="directional")");
  EXPECT_HOLDS(gltf(scene), R"("type": "directional")");
}

// Its density leaves out the choice among lights.
TEST_F(LightsWithoutArea, HydraMultipliesDirectionalLightByTheLightsThatShine) {
  auto scene = lit_by(scene::DirectionalShape{});
  EXPECT_HOLDS(hydra(scene), R"(<multiplier val="1"/>)");
  scene.lights.push_back(scene.lights[0]);
  scene.lights.back().shape = scene::PointShape{};
  scene.lights.push_back(scene.lights.back());
  scene.lights.back().radiance = {};
  EXPECT_HOLDS(hydra(scene), R"(<multiplier val="2"/>)");
  EXPECT_FALSE(adapters::hydra_limits(scene, {{"naive", 1}}).empty());
}

TEST_F(LightsWithoutArea, AreWordsBesideMeshes) {
  adapters::write_obj(lit_by(scene::SpotShape{15, 30}), folder_ / "scene.obj");
  const auto document = json::parse_file(folder_ / "description.json");
  json::ObjectReader description(document);
  auto lamp = description.objects("lamps").at(0);
  EXPECT_EQ(lamp.text("shape"), "spot");
  EXPECT_EQ(lamp.vec3("intensity_W_per_sr"), (Vec3d{3, 2, 1}));
  EXPECT_EQ(lamp.vec3("position_m"), (Vec3d{1, 2, 3}));
  EXPECT_EQ(lamp.vec3("shines_towards").y, -1);
  EXPECT_EQ(lamp.number("outer_half_angle_deg"), 30);
}

TEST_F(LightsWithoutArea, BecomeNoMeshes) {
  const auto meshes = adapters::lights_as_meshes(lit_by(scene::PointShape{}));
  EXPECT_EQ(meshes.lights.size(), 1U);
  EXPECT_EQ(meshes.instances.size(), 1U);
}

// Down is the nadir, and its ring of azimuths counts from x to z. The texels are the map's, of equal area.
TEST_F(LightsWithoutArea, ProfilesForPbrtAreMapsOfTheSphere) {
  scene::IesProfile down{{0, 90}, {0, 360}, {10, 0, 10, 0}, 10};
  const auto image = adapters::pbrt::profile_image(down);
  double sum = 0;
  for (const float texel : image.pixels) sum += texel;
  // The mean over the sphere of 1 - gamma / 90 degrees below the horizon: (1/2) (1 - 2/pi) of the half
  // sphere.
  EXPECT_NEAR(sum / static_cast<double>(image.pixels.size()), (1 - 2 / kPi) / 2, 1e-4);
  EXPECT_NEAR(image.at(0, 0, 0), 1, 0.01) << "the corners of the map are its -Z, our -y";
  EXPECT_EQ(image.at(512, 512, 0), 0);
}

}  // namespace

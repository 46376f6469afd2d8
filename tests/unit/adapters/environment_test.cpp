// What the exporters write of environment maps; that the programs make the right images of it shows in the
// suite everyday.
#include "adapters/environment_image.h"
#include "adapters/gltf/gltf.h"
#include "adapters/hydra/hydra.h"
#include "adapters/hydra/lights.h"
#include "adapters/mitsuba/lights.h"
#include "adapters/mitsuba/mitsuba.h"
#include "adapters/obj/obj.h"
#include "adapters/pbrt/pbrt.h"
#include "adapters/povray/povray.h"
#include "base/files.h"
#include "image/image_io.h"
#include "scene/geometry/generators.h"

#include <gtest/gtest.h>

namespace {

using namespace orbs;
namespace fs = std::filesystem;

#define EXPECT_HOLDS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text).substr(0, 4000)

// 8 x 4 texels that are all different.
class EnvironmentExport : public testing::Test {
 protected:
  EnvironmentExport() {
    auto sky = image::make_image(8, 4, {"R", "G", "B"});
    for (std::size_t i = 0; i < sky.pixels.size(); ++i) sky.pixels[i] = static_cast<float>(i % 7 + i / 3);
    image::write_exr(sky, folder_ / "sky.exr");
  }

  scene::Scene under_sky(const Mat4& matrix, bool is_seen = true) const {
    scene::Scene scene;
    scene.camera.position_m = {0, 0, 5};
    scene.trace_depth = 1;
    scene.textures = {{"sky", folder_ / "sky.exr"}};
    scene.materials = {{"m", scene::Lambert{{0.5, 0.5, 0.5}, {}}}};
    scene.meshes = {scene::make_cube({1})};
    scene.meshes[0].triangle_materials.assign(12, 0);
    scene.instances = {{"i", 0, {}, {}}};
    scene.environment = {
        .radiance = {2, 2, 2}, .map = scene::EnvironmentMap{0, matrix}, .visible_to_camera = is_seen};
    return scene;
  }
  std::string read(const char* name) const { return read_file(folder_ / name); }

  ScratchFolder scratch_{"orbs-environment"};
  fs::path folder_ = scratch_.path();
};

// The radiance at the centre of the texel that a direction of the world lies in.
float red_towards(const image::Image& image, const Mat4& matrix, Vec3d direction) {
  const Vec2d uv = scene::map_coordinates(transform_direction(inverse(matrix).value(), direction));
  return image.at(static_cast<int>(uv.x * image.width), static_cast<int>((1 - uv.y) * image.height), 0);
}

}  // namespace

TEST_F(EnvironmentExport, MirrorsGoIntoTheImage) {
  const Mat4 matrix = rotation_y(30) * scaling({1, -1, 1});
  const auto scene = under_sky(matrix);
  const auto given = image::read_image(folder_ / "sky.exr");
  const auto turned = adapters::turned_environment(scene);
  EXPECT_GT(determinant3(turned.matrix), 0);
  for (const Vec3d d : {Vec3d{1, 0.2, 0.3}, Vec3d{-0.4, -0.9, 1}, Vec3d{0.1, 0.5, -1}})
    EXPECT_EQ(red_towards(turned.image, turned.matrix, d), 2 * red_towards(given, matrix, d));
}

TEST_F(EnvironmentExport, WholeTexelsAreMovedAndOthersSampledAnew) {
  const auto given = image::read_image(folder_ / "sky.exr");
  const auto moved = adapters::environment_in_world(under_sky(rotation_y(90)));
  EXPECT_EQ(moved.width, 8);
  for (const Vec3d d : {Vec3d{1, 0.2, 0.3}, Vec3d{-0.4, -0.9, 1}})
    EXPECT_EQ(red_towards(moved, Mat4{}, d), 2 * red_towards(given, rotation_y(90), d));
  EXPECT_EQ(adapters::environment_in_world(under_sky(rotation_y(50))).width, 16);
  EXPECT_EQ(adapters::environment_in_world(under_sky(rotation_x(90))).width, 16);
}

TEST_F(EnvironmentExport, RowsOfMitsubaInterpolateToOurs) {
  const auto given = image::read_image(folder_ / "sky.exr");
  const auto rows = adapters::mitsuba::rows_on_poles(given);
  EXPECT_EQ(rows.height, 9);
  for (int x = 0; x < 8; ++x) {
    for (int y = 0; y < 4; ++y) EXPECT_EQ(rows.at(x, 2 * y + 1, 0), given.at(x, y, 0));
    EXPECT_EQ(rows.at(x, 0, 0), given.at(x, 0, 0));
    EXPECT_EQ(rows.at(x, 8, 0), given.at(x, 3, 0));
    EXPECT_EQ(rows.at(x, 4, 0), (given.at(x, 1, 0) + given.at(x, 2, 0)) / 2);
  }
}

TEST_F(EnvironmentExport, IsWrittenByEachProgramsWords) {
  adapters::write_mitsuba(under_sky(Mat4{}, false), folder_ / "m.xml");
  EXPECT_HOLDS(read("m.xml"),
               R"(<emitter type="envmap"><string name="filename" value="m-environment.exr"/>)");
  EXPECT_HOLDS(read("m.xml"), R"(<boolean name="hide_emitters" value="true"/>)");
  adapters::write_povray(under_sky(Mat4{}), {}, folder_ / "p.pov");
  EXPECT_HOLDS(read("p.pov"),
               R"(sky_sphere { pigment { image_map { exr "p-environment.exr" map_type 1 interpolate 2 })");
  adapters::write_povray(under_sky(Mat4{}, false), {}, folder_ / "h.pov");
  EXPECT_HOLDS(read("h.pov"), "hollow no_image no_shadow");
  EXPECT_EQ(read("h.pov").find("sky_sphere"), std::string::npos);
  adapters::write_hydra(under_sky(Mat4{}, false), {}, folder_ / "x.xml");
  EXPECT_HOLDS(read("x.xml"), R"(type="sky")");
  EXPECT_HOLDS(read("x.xml"), "<back><texture");
  EXPECT_HOLDS(read("x.xml"), "x-environment.image4f");
  adapters::write_obj(under_sky(rotation_y(90), false), folder_ / "scene.obj");
  EXPECT_HOLDS(read("description.json"), R"("seen_by_camera": false)");
  EXPECT_HOLDS(read("description.json"), "texture0.exr");
}

TEST_F(EnvironmentExport, IsRefusedWithAReasonWhereThereIsNoWay) {
  const auto scene = under_sky(Mat4{}, false);
  const auto reasons = [](const std::vector<std::string>& all) {
    std::string out;
    for (const auto& one : all) out += one + "\n";
    return out;
  };
  EXPECT_HOLDS(reasons(adapters::pbrt_limits(scene)), "pbrt multiplies the colours of a sky");
  EXPECT_HOLDS(reasons(adapters::pbrt_limits(scene)), "pbrt's camera sees all");
  EXPECT_HOLDS(reasons(adapters::gltf_limits(scene)), "has no environment");
  EXPECT_EQ(reasons(adapters::mitsuba_limits(scene)), "");
  EXPECT_EQ(reasons(adapters::povray_limits(scene, {})), "");
  auto lit = scene;
  lit.lights = {{"l", scene::SphereShape{1}, {1, 1, 1}, Mat4{}, {}}};
  EXPECT_HOLDS(reasons(adapters::mitsuba_limits(lit)), "hides all emitters, or none");
  auto sunny = image::make_image(64, 32, {"R", "G", "B"});
  sunny.at(9, 9, 1) = 1;
  image::write_exr(sunny, folder_ / "sky.exr");
  EXPECT_TRUE(adapters::has_sun(scene));
  EXPECT_HOLDS(reasons(adapters::povray_limits(scene, {})), "the environment has a sun");
}

// What the exporters write of opacities, normals, bumps and second coordinates; that the programs make the
// right images of it shows in the suite everyday.
#include "adapters/material_meshes.h"
#include "adapters/mitsuba/mitsuba.h"
#include "adapters/pbrt/pbrt.h"
#include "base/files.h"
#include "image/image_io.h"
#include "scene/geometry/generators.h"

#include <gtest/gtest.h>

namespace {

using namespace orbs;
namespace fs = std::filesystem;

// A card with a texture of 16 x 16 texels.
scene::Scene card_with(const scene::SurfaceDetail& detail, const Mat4& matrix = {}) {
  scene::Scene scene;
  scene.camera.position_m = {0, 5, 0};
  scene.camera.up = {0, 0, -1};
  scene.textures = {{"ramp", ORBS_SOURCE_DIR "/data/common/textures/height_ramp.png"}};
  scene.textures[0].encoding = scene::Encoding::Linear;
  scene.materials = {{"m", scene::Lambert{{0.5, 0.5, 0.5}, {}}, detail}};
  scene.meshes = {scene::make_plane({1})};
  scene.meshes[0].triangle_materials.assign(2, 0);
  // v along x and u along z: to the side of normal x u.
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3f p = scene.meshes[0].positions[i];
    scene.meshes[0].uvs[i] = {p.z, p.x};
  }
  scene.instances = {{"i", 0, matrix, {}}};
  return scene;
}

const scene::SurfaceDetail kRaised{1, {}, {}, scene::BumpMap{{0, {}}, -2}};

class SurfaceDetail : public testing::Test {
 protected:
  std::string mitsuba(const scene::Scene& scene) {
    adapters::write_mitsuba(scene, folder_ / "a.xml");
    return read_file(folder_ / "a.xml");
  }
  std::string pbrt(const scene::Scene& scene) {
    adapters::write_pbrt(scene, folder_ / "a.pbrt");
    return read_file(folder_ / "a.pbrt");
  }
  ScratchFolder scratch_{"orbs-surface-detail"};
  fs::path folder_ = scratch_.path();
};

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST_F(SurfaceDetail, HeightsAreMetresOfTheWorld) {
  EXPECT_TRUE(has(mitsuba(card_with(kRaised)), "<bsdf type=\"bumpmap\""));
  const auto heights = image::read_image(folder_ / "a-heights0.exr");
  // The top right texel is 6 * 15 + 4 * 15 of 255, the bottom left one 0.
  EXPECT_NEAR(heights.at(15, 0, 0), -2 * 150 / 255.0, 1e-6);
  EXPECT_EQ(heights.at(0, 15, 0), 0);
  EXPECT_TRUE(has(pbrt(card_with(kRaised)), "\"texture displacement\" \"material0-heights\""));
}

TEST_F(SurfaceDetail, OfWhatAMatrixMirrorsAnInstanceIsWritten) {
  const Mat4 mirror = scaling({-1, 1, 1});
  EXPECT_TRUE(has(mitsuba(card_with(kRaised, mirror)), "<shape type=\"instance\">"));
  EXPECT_FALSE(has(mitsuba(card_with(kRaised)), "<shape type=\"instance\">"));
  EXPECT_FALSE(has(mitsuba(card_with({}, mirror)), "<shape type=\"instance\">"));
  EXPECT_TRUE(has(pbrt(card_with(kRaised)), "ObjectInstance"));
}

TEST_F(SurfaceDetail, PbrtHasNoBumpsWhereVIsNotUTurnedByAQuarter) {
  auto scene = card_with(kRaised);
  EXPECT_EQ(adapters::pbrt_limits(scene), std::vector<std::string>{});
  for (auto& uv : scene.meshes[0].uvs) uv.y = -uv.y;
  EXPECT_EQ(adapters::pbrt_limits(scene).size(), 1U);
  for (auto& uv : scene.meshes[0].uvs) uv.y = -2 * uv.y;
  EXPECT_EQ(adapters::pbrt_limits(scene).size(), 1U);
  scene.materials[0].detail = {};
  EXPECT_EQ(adapters::pbrt_limits(scene), std::vector<std::string>{});
}

TEST_F(SurfaceDetail, NormalMapsOfMirroredFramesHaveGreenTurnedOver) {
  auto scene = card_with({1, {}, scene::NormalMap{{0, {}}, 0.5}, {}});
  EXPECT_FALSE(has(mitsuba(scene), "-mirrored"));
  EXPECT_TRUE(has(pbrt(scene), "\"string normalmap\" \"a-normals0.exr\""));
  scene.instances.push_back({"mirrored", 0, scaling({-1, 1, 1}), {}});
  EXPECT_TRUE(has(mitsuba(scene), "<ref id=\"material0-mirrored\"/>"));
  EXPECT_TRUE(has(mitsuba(scene), "<ref id=\"material0\"/>"));
  EXPECT_TRUE(has(pbrt(scene), "\"string normalmap\" \"a-normals0-mirrored.exr\""));
  const auto plain = image::read_image(folder_ / "a-normals0.exr");
  const auto mirrored = image::read_image(folder_ / "a-normals0-mirrored.exr");
  const float texel = 150 / 255.0F;
  EXPECT_NEAR(plain.at(15, 0, 1), 0.5F + 0.5F * (texel - 0.5F), 1e-6);
  EXPECT_NEAR(mirrored.at(15, 0, 1), 0.5F - 0.5F * (texel - 0.5F), 1e-6);
  EXPECT_EQ(mirrored.at(15, 0, 0), plain.at(15, 0, 0));
  EXPECT_NEAR(plain.at(15, 0, 2), texel, 1e-6) << "the strength is none of z";
  // Two mirrors are none.
  for (auto& uv : scene.meshes[0].uvs) uv.y = -uv.y;
  scene.instances.erase(scene.instances.begin());
  EXPECT_FALSE(has(mitsuba(scene), "<ref id=\"material0-mirrored\"/>"));
}

TEST_F(SurfaceDetail, OneSetOfCoordinatesIsWritten) {
  auto scene = card_with(kRaised);
  scene.meshes[0].second_uvs = {{0.25F, 0}, {0.25F, 1}, {0, 1}, {0, 0}};
  scene.materials[0].detail.bump_map->texture.uv_set = 1;
  EXPECT_EQ(adapters::material_meshes(scene).at(0).mesh.uvs, scene.meshes[0].second_uvs);
  EXPECT_EQ(adapters::uv_set_limit(scene, 0, "X"), "");
  std::get<scene::Lambert>(scene.materials[0].model).texture = scene::TextureUse{0, {}};
  EXPECT_EQ(adapters::uv_set_limit(scene, 0, "X"),
            "material 'm' looks textures up at both sets of texture coordinates: X has one");
}

// Mitsuba mirrors textures itself, for pbrt the mirror images stand beside the image.
TEST_F(SurfaceDetail, MirroredOpacitiesAreMirroredOnce) {
  auto scene = card_with({0.5, scene::TextureUse{0, {}}, {}, {}});
  scene.textures[0].wrap_u = scene.textures[0].wrap_v = scene::Wrap::Mirror;
  mitsuba(scene);
  EXPECT_EQ(image::read_image(folder_ / "a-opacity0.exr").width, 16);
  pbrt(scene);
  EXPECT_EQ(image::read_image(folder_ / "a-opacity0.exr").width, 32);
}

}  // namespace

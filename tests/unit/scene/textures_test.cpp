// Textures of floats whose texels are no reflectances, and meshes on which a texture is one texel.
#include "base/error.h"
#include "image/image_io.h"
#include "scene/load/load_scene.h"
#include "structure/source_files.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace {

using namespace orbs;
using structure::TestFolder;

// The file with one texel changed, from 4 x 3 of 0.5.
void write_texture(const std::filesystem::path& file,
                   float value,
                   const std::vector<std::string>& channels = {"R", "G", "B"}) {
  auto image = image::make_image(4, 3, channels);
  for (float& x : image.pixels) x = 0.5F;
  image.at(2, 1, channels.size() > 1 ? 1 : 0) = value;
  image::write_exr(image, file);
}

std::string scene_text(const std::string& material, const std::string& mesh) {
  return fmt::format(R"({{"format": "orbs-scene/1", "name": "s",
"camera": {{"position": [0, 0, 5], "look_at": [0, 0, 0]}},
"textures": [{{"name": "t", "file": "t.exr"}}],
"materials": [{}, {{"name": "plain", "type": "mirror", "reflectance": [1, 1, 1]}}],
"meshes": [{}],
"instances": [{{"mesh": "a"}}, {{"mesh": "a"}}]}})",
                     material, mesh);
}

const std::string kPlane = R"({"name": "a", "generator": "plane", "half_size": 1, "material": "m"})";
const std::string kLambert =
    R"({"name": "m", "type": "lambert", "reflectance": [0.5, 0.5, 0.5], "texture": "t"})";
const std::string kEmission = R"({"name": "m", "type": "emission", "radiance": [1, 1, 1], "texture": "t"})";

std::string refusal(const std::string& material, float value, const std::vector<std::string>& channels) {
  const TestFolder folder("texture-values");
  write_texture(folder.path() / "t.exr", value, channels);
  try {
    scene::load_scene_text("scene.json", scene_text(material, kPlane), folder.path());
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

std::vector<std::string> warnings(const std::string& mesh, const std::string& material = kLambert) {
  const TestFolder folder("texture-warnings");
  write_texture(folder.path() / "t.exr", 0.5F);
  folder.write("bare.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n");
  folder.write("equal.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvt 0.25 0.75\nf 1/1/1 2/1/1 3/1/1\n");
  folder.write("with.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvt 0 0\nvt 1 1\nf 1/1/1 2/1/1 3/2/1\n");
  folder.write("two.obj",
               "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvt 0 0\nvt 1 1\nusemtl plain\nf 1/1/1 2/1/1 3/2/1\n"
               "usemtl m\nf 1//1 2//1 3//1\n");
  return scene::load_scene_text("scene.json", scene_text(material, mesh), folder.path()).notes.warnings;
}

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinite = std::numeric_limits<float>::infinity();

}  // namespace

TEST(Textures, TexelsThatAreNoReflectanceAreNamed) {
  const std::vector<std::string> rgb{"R", "G", "B"};
  EXPECT_EQ(refusal(kLambert, 1, rgb), "");
  for (const auto& [value, text] : std::vector<std::pair<float, std::string>>{
           {kNan, "nan in channel G; texels must be finite"},
           {kInfinite, "inf in channel G; texels must be finite"},
           {-0.25F, "-0.25 in channel G; texels must not be negative"},
           {1.5F, "1.5 in channel G; those of a reflectance must not be above 1"}}) {
    const auto error = refusal(kLambert, value, rgb);
    EXPECT_NE(error.find("scene.json:3"), std::string::npos) << error;
    EXPECT_NE(error.find("/textures/0/file: "), std::string::npos) << error;
    EXPECT_NE(error.find("t.exr: texel (2, 1), counted from 0 at the top left, has " + text),
              std::string::npos)
        << error;
  }
}

TEST(Textures, RadianceMayBeAboveOneAndNotNegative) {
  EXPECT_EQ(refusal(kEmission, 1e6F, {"R", "G", "B"}), "");
  for (const float wrong : {kNan, kInfinite, -1e-6F})
    EXPECT_NE(refusal(kEmission, wrong, {"R", "G", "B"}), "");
}

TEST(Textures, ThoseThatNoMaterialHasAreCheckedAsRadiance) {
  const std::string plain = R"({"name": "m", "type": "mirror", "reflectance": [1, 1, 1]})";
  EXPECT_EQ(refusal(plain, 2, {"R", "G", "B"}), "");
  EXPECT_NE(refusal(plain, kNan, {"R", "G", "B"}), "");
}

TEST(Textures, OnlyColoursAreChecked) {
  EXPECT_EQ(refusal(kLambert, 0.5F, {"A", "B", "G", "R", "Z"}), "");
  const auto grey = refusal(kLambert, -1, {"Y"});
  EXPECT_NE(grey.find("texel (2, 1), counted from 0 at the top left, has -1 in channel Y"), std::string::npos)
      << grey;
  const auto normals = refusal(kLambert, 0.5F, {"Z", "N.X", "N.Y"});
  EXPECT_NE(normals.find("/textures/0/file: "), std::string::npos) << normals;
  EXPECT_NE(normals.find("has the channels Z, N.X, N.Y; expected R, G and B, or Y alone"), std::string::npos)
      << normals;
}

TEST(Textures, OneTexelEverywhereIsWarnedOf) {
  const auto bare = warnings(R"({"name": "a", "file": "bare.obj", "material": "m"})");
  ASSERT_EQ(bare.size(), 1U) << "once, though there are two instances";
  EXPECT_EQ(
      bare[0],
      "scene.json:5: mesh 'a' shows the textured material 'm', and its texture coordinates there are absent "
      "or all (0, 0): the texture is one texel everywhere");
  const auto equal = warnings(R"({"name": "a", "file": "equal.obj", "material": "m"})");
  ASSERT_EQ(equal.size(), 1U);
  EXPECT_NE(equal[0].find("all (0.25, 0.75)"), std::string::npos) << equal[0];
  EXPECT_EQ(warnings(R"({"name": "a", "file": "two.obj"})").size(), 1U) << "where the material shows";
}

TEST(Textures, NothingIsWarnedOfWhereTheyShow) {
  EXPECT_TRUE(warnings(kPlane).empty());
  EXPECT_TRUE(warnings(R"({"name": "a", "file": "with.obj", "material": "m"})").empty());
  EXPECT_TRUE(warnings(R"({"name": "a", "file": "bare.obj", "material": "plain"})").empty());
}

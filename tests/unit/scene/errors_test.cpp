// A tour of broken scenes: each gives one error that names the file, the line and the key, and says what
// would be right.
#include "base/error.h"
#include "base/files.h"
#include "scene/geometry/obj.h"
#include "scene/geometry/ply.h"
#include "scene/load/load_scene.h"

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

namespace {

using namespace orbs;

struct BrokenScene {
  const char* name;
  std::string find;                    // in kGood
  std::string replace;                 // by this
  std::vector<std::string> complaint;  // all of these must stand in the message
};

const std::string kGood = R"({
  "format": "orbs-scene/1",
  "name": "good",
  "camera": {"position": [0, 0, 5], "look_at": [0, 0, 0], "fov_y": 45, "width": 64, "height": 64},
  "textures": [{"name": "chess", "file": "data/common/textures/chess_white.png"}],
  "materials": [
    {"name": "grey", "type": "lambert", "reflectance": [0.5, 0.5, 0.5], "texture": "chess"},
    {"name": "glass", "type": "glass", "ior": 1.5}
  ],
  "meshes": [
    {"name": "ball", "generator": "sphere", "radius": 1, "segments": 16, "material": "grey"},
    {"name": "triangle", "positions": [0, 0, 0, 1, 0, 0, 0, 1, 0], "normals": [0, 0, 1, 0, 0, 1, 0, 0, 1],
     "triangles": [0, 1, 2], "material": "grey"}
  ],
  "instances": [
    {"mesh": "ball", "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1], "remap": ["grey", "glass"]},
    {"mesh": "triangle"}
  ],
  "lights": [{"type": "rect", "half_width": 1, "half_length": 1, "radiance": [1, 1, 1],
              "ies": {"file": "data/common/ies/batwing_asymmetric.ies"}}],
  "integrator": {"trace_depth": 5}
}
)";

const std::vector<BrokenScene> kBroken{
    {"UnknownKey",
     "\"fov_y\"",
     "\"fovy\"",
     {"scene.json:4:", "/camera/fovy", "unknown key", "did you mean 'fov_y'"}},
    {"MissingKey",
     "\"position\": [0, 0, 5], ",
     "",
     {"scene.json:4:", "/camera", "key 'position' is missing"}},
    {"WrongType",
     "\"width\": 64",
     "\"width\": \"64\"",
     {"scene.json:4:", "/camera/width", "must be a number, is string"}},
    {"OutOfRange",
     "[0.5, 0.5, 0.5]",
     "[0.5, 1.5, 0.5]",
     {"scene.json:7:", "/materials/0/reflectance/1", "[0, 1]", "1.5"}},
    {"NotANumber", "\"fov_y\": 45", "\"fov_y\": NaN", {"scene.json:4:", "not valid JSON"}},
    {"TooLargeForANumber", "\"fov_y\": 45", "\"fov_y\": 1e999", {"scene.json", "not usable JSON"}},
    {"GivenTwice",
     "\"name\": \"good\",",
     "\"name\": \"good\", \"name\": \"bad\",",
     {"key 'name' appears twice"}},
    {"NotClosed",
     "\"integrator\": {\"trace_depth\": 5}\n}",
     "\"integrator\": {\"trace_depth\": 5}\n",
     {"scene.json:", "not valid JSON"}},
    {"WrongFormat", "orbs-scene/1", "orbs-scene/7", {"scene.json:2:", "/format", "orbs-scene/1"}},
    {"DanglingTexture",
     "\"texture\": \"chess\"",
     "\"texture\": \"ches\"",
     {"scene.json:7:", "there is no texture 'ches'", "did you mean 'chess'"}},
    {"DanglingMaterial",
     "\"segments\": 16, \"material\": \"grey\"",
     "\"segments\": 16, \"material\": \"gray\"",
     {"scene.json:11:", "there is no material 'gray'", "did you mean 'grey'"}},
    {"DanglingMesh",
     "{\"mesh\": \"triangle\"}",
     "{\"mesh\": \"triangel\"}",
     {"scene.json:17:", "there is no mesh 'triangel'"}},
    {"DanglingRemap",
     "[\"grey\", \"glass\"]",
     "[\"grey\", \"glas\"]",
     {"scene.json:16:", "/instances/0/remap/1", "there is no material 'glas'"}},
    {"OddRemap",
     "[\"grey\", \"glass\"]",
     "[\"grey\", \"glass\", \"grey\"]",
     {"scene.json:16:", "/instances/0/remap", "3 names: an odd number"}},
    {"RemapTwice",
     "[\"grey\", \"glass\"]",
     "[\"grey\", \"glass\", \"grey\", \"grey\"]",
     {"/instances/0/remap/2", "'grey' is replaced twice"}},
    {"IndexOutOfRange",
     "\"triangles\": [0, 1, 2]",
     "\"triangles\": [0, 1, 3]",
     {"scene.json:13:", "/triangles/2", "index 3 is out of range: there are 3 vertices"}},
    {"ZeroNormal",
     "\"normals\": [0, 0, 1, 0, 0, 1, 0, 0, 1]",
     "\"normals\": [0, 0, 0, 0, 0, 1, 0, 0, 1]",
     {"scene.json:12:", "normal 0 must be finite and not zero"}},
    {"TooFewNormals",
     "\"normals\": [0, 0, 1, 0, 0, 1, 0, 0, 1]",
     "\"normals\": [0, 0, 1]",
     {"scene.json:12:", "3 positions and 1 normals"}},
    {"SingularMatrix",
     "[1, 0, 0, 0, 0, 1",
     "[1, 0, 0, 0, 0, 0",
     {"scene.json:16:", "/instances/0/matrix", "not invertible"}},
    {"ShortMatrix",
     "0, 0, 0, 0, 1], \"remap\"",
     "0, 0, 0], \"remap\"",
     {"scene.json:16:", "must hold 16 numbers, holds 14"}},
    {"ProjectiveMatrix",
     "0, 0, 0, 0, 1], \"remap\"",
     "0, 0, 1, 0, 1], \"remap\"",
     {"/instances/0/matrix", "last row must be 0 0 0 1"}},
    {"UnknownStep",
     "[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]",
     "[{\"rotate\": 3}]",
     {"scene.json:16:", "unknown step", "did you mean 'rotate_"}},
    {"MissingTextureFile",
     "chess_white.png",
     "chess_wite.png",
     {"scene.json:5:", "/textures/0/file", "there is no file", "chess_wite.png"}},
    {"MissingProfile",
     "batwing_asymmetric.ies",
     "none.ies",
     {"scene.json:20:", "/lights/0/ies/file", "there is no file"}},
    {"ProfileThatIsNone",
     "data/common/ies/batwing_asymmetric.ies",
     "README.md",
     {"README.md", "not a usable LM-63 file", "while loading the profile that scene.json:20"}},
    {"UnknownGenerator",
     "\"generator\": \"sphere\"",
     "\"generator\": \"spere\"",
     {"scene.json:11:", "'spere' is not one of", "did you mean 'sphere'"}},
    {"UnknownMaterialType",
     "\"type\": \"glass\"",
     "\"type\": \"glas\"",
     {"scene.json:8:", "'glas' is not one of"}},
    {"NegativeRadiance",
     "\"radiance\": [1, 1, 1]",
     "\"radiance\": [1, -1, 1]",
     {"scene.json:19:", "/lights/0/radiance/1", "must lie in [0, 3.4"}},
    {"UpAlongTheView",
     "\"fov_y\": 45",
     "\"up\": [0, 0, 1]",
     {"scene.json:4:", "/camera/up", "parallel to the view"}},
    {"PixelsTooFine",
     "\"fov_y\": 45",
     "\"fov_y\": 0.002",
     {"scene.json:4:", "/camera/fov_y", "at least 1e-06 rad", "5.454e-07"}},
    {"NoView",
     "\"look_at\": [0, 0, 0]",
     "\"look_at\": [0, 0, 5]",
     {"/camera/look_at", "must differ from position"}},
    {"NoDepth",
     "\"trace_depth\": 5",
     "\"trace_depth\": 0",
     {"scene.json:21:", "/integrator/trace_depth", "[1, 1000]"}},
    {"RunsTooLong",
     "\"segments\": 16, \"material\": \"grey\"",
     "\"segments\": 16, \"triangle_materials\": [{\"material\": \"grey\", \"count\": 300}]",
     {"scene.json:11:", "/triangle_materials/0/count", "beyond the mesh's 256 triangles"}},
    {"RunsTooShort",
     "\"segments\": 16, \"material\": \"grey\"",
     "\"segments\": 16, \"triangle_materials\": [{\"material\": \"grey\", \"count\": 3}]",
     {"scene.json:11:", "add up to 3, the mesh has 256 triangles"}},
    {"HugeMesh",
     "\"segments\": 16",
     "\"segments\": 100000",
     {"scene.json:11:", "/meshes/0/segments", "[3, 4096]"}},
};

std::string error_of(const std::string& text) {
  try {
    scene::load_scene_text("scene.json", text, ORBS_SOURCE_DIR);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

class BrokenSceneTest : public testing::TestWithParam<BrokenScene> {};

std::string file_error(const std::string& extension, const std::string& content) {
  const ScratchFolder scratch("orbs-broken-mesh");
  const auto file = scratch.path() / ("mesh" + extension);
  write_file(file, content);
  const std::string scene =
      R"({"format": "orbs-scene/1", "name": "m", "camera": {"position": [0, 0, 5], "look_at": [0, 0, 0]},
    "materials": [{"name": "a", "type": "mirror", "reflectance": [1, 1, 1]}], "meshes": [{"name": "m", "file": ")" +
      file.string() + R"("}]})";
  return error_of(scene);
}

}  // namespace

TEST(Scene, TheUnbrokenOneLoads) { EXPECT_EQ(error_of(kGood), ""); }

TEST_P(BrokenSceneTest, GivesOneErrorThatNamesThePlace) {
  const auto& broken = GetParam();
  std::string text = kGood;
  const auto at = text.find(broken.find);
  ASSERT_NE(at, std::string::npos) << broken.find;
  text.replace(at, broken.find.size(), broken.replace);
  const std::string error = error_of(text);
  for (const auto& part : broken.complaint)
    EXPECT_NE(error.find(part), std::string::npos) << "'" << part << "' is not in:\n" << error;
}

INSTANTIATE_TEST_SUITE_P(Tour, BrokenSceneTest, testing::ValuesIn(kBroken), [](const auto& tested) {
  return std::string(tested.param.name);
});

TEST(BrokenMeshFile, NamesFileAndLine) {
  EXPECT_NE(
      file_error(".obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").find(".obj:4: each corner needs a normal"),
      std::string::npos);
  EXPECT_NE(file_error(".obj", "v 0 0 0\nvn 0 0 1\nf 1//1 2//1 3//1\n")
                .find(".obj:3: position index 2 is out of range"),
            std::string::npos);
  EXPECT_NE(file_error(".obj", "v 0 x 0\n").find(".obj:1: 'x' is not a number"), std::string::npos);
  EXPECT_NE(file_error(".obj", "").find("there is no face"), std::string::npos);
  EXPECT_NE(file_error(".obj", "v 0 0 0\nvn 0 0 1\nusemtl b\nf 1//1 1//1 1//1\n")
                .find("usemtl: there is no material 'b'"),
            std::string::npos);
  EXPECT_NE(file_error(".obj", "v 0 0 0\nsurf 0 1 0 1 1 2 3 4\n").find(".obj:2: 'surf' is not read here"),
            std::string::npos);
}

TEST(ObjFile, IsReadWithTabsAsWithBlanks) {
  const std::string text =
      "o one\ns off\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nusemtl red\nf 1//1 2//1 3//1\n";
  auto tabs = text;
  std::replace(tabs.begin(), tabs.end(), ' ', '\t');
  const auto file = scene::parse_obj("a.obj", tabs);
  EXPECT_EQ(file.mesh.positions.size(), 3U);
  EXPECT_EQ(file.material_names, std::vector<std::string>{"red"});
  EXPECT_EQ(file.mesh.triangle_materials, scene::parse_obj("a.obj", text).mesh.triangle_materials);
}

TEST(ObjFile, MayBeginWithAByteOrderMark) {
  const auto file =
      scene::parse_obj("a.obj", "\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n");
  EXPECT_EQ(file.mesh.positions.size(), 3U);
}

// A search through all names so far for each line would take a minute.
TEST(BrokenMeshFile, AHundredThousandMaterialNamesAreReadAtOnce) {
  std::string text;
  for (int i = 0; i < 100000; ++i) text += "usemtl material_with_a_long_name_" + std::to_string(i) + "\n";
  EXPECT_NE(file_error(".obj", text).find("there is no face"), std::string::npos);
}

TEST(BrokenMeshFile, PlyIndicesAreWholeNumbers) {
  const std::string vertices =
      "ply\n"
      "format ascii 1.0\n"
      "element vertex 3\n"
      "property float x\n"
      "property float y\n"
      "property float z\n"
      "property float nx\n"
      "property float ny\n"
      "property float nz\n"
      "element face 1\n"
      "property list uchar float vertex_indices\n"
      "end_header\n"
      "0 0 0 0 0 1\n"
      "1 0 0 0 0 1\n"
      "0 1 0 0 0 1\n";
  EXPECT_NE(file_error(".ply", vertices + "3 0 1 1.5\n")
                .find("vertex index 1.5 is out of range or no whole number"),
            std::string::npos);
}

TEST(BrokenMeshFile, PlyHeadersAreNotBelieved) {
  EXPECT_NE(file_error(".ply", "plx\n").find("does not start with 'ply'"), std::string::npos);
  EXPECT_NE(file_error(".ply", "ply\nformat ascii 1.0\nelement vertex 99999999999\n")
                .find("element count '99999999999' is impossible"),
            std::string::npos);
  EXPECT_NE(file_error(".ply", "ply\nformat binary_middle_endian 1.0\nend_header\n")
                .find("binary_middle_endian is not supported"),
            std::string::npos);
  EXPECT_NE(file_error(".ply",
                       "ply\n"
                       "format ascii 1.0\n"
                       "element vertex 2\n"
                       "property float x\n"
                       "property float y\n"
                       "property float z\n"
                       "property float nx\n"
                       "property float ny\n"
                       "property float nz\n"
                       "end_header\n"
                       "1 2 3 4 5 6 7")
                .find("ends within its data"),
            std::string::npos);
  EXPECT_NE(file_error(".ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n")
                .find("lack the property 'y'"),
            std::string::npos);
}

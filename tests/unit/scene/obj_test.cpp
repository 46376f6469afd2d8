// Forms of OBJ files that programs write.
#include "scene/geometry/obj.h"

#include "base/error.h"
#include "scene/load/load_scene.h"
#include "structure/source_files.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace {

using namespace orbs;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

const std::string kCorners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\n";
const std::string kTriangle = kCorners + "f 1//1 2//1 3//1\n";

std::string refusal(const std::string& text, scene::FileNormals normals = scene::FileNormals::Required) {
  try {
    scene::parse_obj("a.obj", text, normals);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

void expect_as_the_triangle(const std::string& text) {
  ASSERT_EQ(refusal(text), "") << text;
  EXPECT_EQ(scene::parse_obj("a.obj", text).mesh, scene::parse_obj("a.obj", kTriangle).mesh) << text;
}

// The error of a scene that shows the file by materials "dark wood" and "dark metal".
std::string scene_error(const std::string& obj) {
  const structure::TestFolder folder("obj-names");
  folder.write("a.obj", obj);
  try {
    scene::load_scene_text(
        "scene.json",
        R"({"format": "orbs-scene/1", "name": "s", "camera": {"position": [0, 0, 5], "look_at": [0, 0, 0]},
"materials": [{"name": "dark wood", "type": "mirror", "reflectance": [1, 1, 1]},
              {"name": "dark metal", "type": "mirror", "reflectance": [1, 1, 1]}],
"meshes": [{"name": "a", "file": "a.obj"}]})",
        folder.path());
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST(ObjFile, CutsAConcaveFaceAtItsConcaveCorner) {
  const auto file =
      scene::parse_obj("a.obj", "v 2 0 0\nv 0.5 0.5 0\nv 0 2 0\nv 0 0 0\nvn 0 0 1\nf 1//1 2//1 3//1 4//1\n");
  EXPECT_EQ(file.mesh.triangles.size(), 2U);
  double area = 0;
  for (const auto& t : file.mesh.triangles) {
    const auto at = [&](std::size_t k) { return cast<double>(file.mesh.positions[t[k]]); };
    area += length(cross(at(1) - at(0), at(2) - at(0))) / 2;
  }
  EXPECT_DOUBLE_EQ(area, 1);
  EXPECT_TRUE(file.warnings.empty());
}

TEST(ObjFile, KeepsTheFanOfAConvexFace) {
  const auto file = scene::parse_obj(
      "a.obj", "v 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1 4//1 5//1\n");
  EXPECT_EQ(file.mesh.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
}

TEST(ObjFile, WarnsOfFacesThatCrossThemselves) {
  const auto file =
      scene::parse_obj("a.obj", kCorners + "v 1 1 0\nf 1//1 4//1 2//1 3//1\nf 1//1 4//1 2//1 3//1\n");
  ASSERT_EQ(file.warnings.size(), 1U);
  EXPECT_EQ(
      file.warnings[0],
      "a.obj:6: edges of this face cross, so no triangles cover it once, and it is a fan around its first "
      "corner; faces of this kind in the file: 2");
  EXPECT_EQ(file.mesh.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}, {0, 1, 2}, {0, 2, 3}}));
}

TEST(ObjFile, TakesTheRestOfTheLineAsTheNameOfAMaterial) {
  const auto file = scene::parse_obj("a.obj", kCorners + "usemtl dark wood \r\nf 1//1 2//1 3//1\r\n" +
                                                  "usemtl\tdark metal #2\nf 1//1 2//1 3//1 # not a name\n" +
                                                  "#usemtl other\nusemtl C:\\textures\\\nf 1//1 2//1 3//1\n");
  EXPECT_EQ(file.material_names, (std::vector<std::string>{"dark wood", "dark metal #2", "C:\\textures\\"}));
  EXPECT_EQ(file.mesh.triangle_materials, (std::vector{0, 1, 2}));
  EXPECT_EQ(
      scene_error(kCorners + "usemtl dark wood\nf 1//1 2//1 3//1\nusemtl dark metal\nf 1//1 2//1 3//1\n"),
      "");
  const auto error = scene_error(kCorners + "usemtl dark wool\nf 1//1 2//1 3//1\n");
  EXPECT_NE(error.find("/meshes/0/file: line 5 of it, usemtl: there is no material 'dark wool' (did you mean "
                       "'dark wood'?)"),
            std::string::npos)
      << error;
}

TEST(ObjFile, FacesWithoutAMaterialAreNamed) {
  EXPECT_EQ(
      scene::parse_obj("a.obj", kCorners + "usemtl a\nusemtl \nf 1//1 2//1 3//1\n").mesh.triangle_materials,
      std::vector{-1});
  const auto error = scene_error(kTriangle);
  EXPECT_NE(
      error.find("/meshes/0/file: a face of it stands before the first usemtl, or after one without a name"),
      std::string::npos)
      << error;
}

TEST(ObjFile, LeavesOutWhatHasNoSurface) {
  for (const char* more : {"l 1 2\n",
                           "l 1/1 2/1\n",
                           "p 1\n",
                           "vp 0.5\n",
                           "vw 1 0.5\n",
                           "lod 1\n",
                           "mg 1 0.5\n",
                           "bevel on\n",
                           "c_interp off\n",
                           "d_interp off\n",
                           "usemap map.png\n",
                           "maplib a.map\n",
                           "shadow_obj a.obj\n",
                           "trace_obj a.obj\n",
                           "usemtl\n",
                           "g a b c\n",
                           "o C:\\\n",
                           "mtllib C:\\dark wood\\\n",
                           "# C:\\\n",
                           "   # a comment behind blanks\n",
                           "s off\n"})
    expect_as_the_triangle(kCorners + more + "f 1//1 2//1 3//1\n");
  for (const char* wrong : {"curv 0 1 1 2", "surf 0 1 0 1 1 2 3 4", "cstype bezier", "call a.obj", "x 1"})
    EXPECT_NE(refusal(kTriangle + wrong + "\n").find("a.obj:6: '"), std::string::npos) << wrong;
}

TEST(ObjFile, GoesOnInTheNextLineBehindABackslash) {
  expect_as_the_triangle(kCorners + "f 1//1 \\\n2//1 3//1\n");
  expect_as_the_triangle("v 0 \\\r\n 0\\\r\n 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf \\\n1//1 \\\n2//1 3//1\n");
  expect_as_the_triangle(kCorners + "\\\n\nf\\\n 1//1 2//1 3//1\n");  // alone, and right behind the keyword
  EXPECT_NE(refusal(kCorners + "f 1//1 \\\n2//1 3//1\nf 1//1 2//1 9//1\n").find("a.obj:7: position index 9"),
            std::string::npos)
      << "lines count on";
  EXPECT_NE(refusal(kCorners + "f 1//1 \\\n2//1 9//1\n").find("a.obj:5: position index 9"),
            std::string::npos);
  EXPECT_NE(refusal(kCorners + "f 1//1 2//1 \\").find("a.obj:5: a"), std::string::npos);
}

TEST(ObjFile, FacesMayStandBeforeTheirVertices) {
  expect_as_the_triangle("f 1//1 2//1 3//1\n" + kCorners);
  EXPECT_NE(refusal("f -1//1 2//1 3//1\n" + kCorners)
                .find("a.obj:1: position index -1 is out of range: there are 0"),
            std::string::npos)
      << "backwards from here";
  EXPECT_NE(
      refusal("f 1//1 2//1 4//1\n" + kCorners).find("a.obj:1: position index 4 is out of range: there are 3"),
      std::string::npos);
}

TEST(ObjFile, TextureCoordinatesHaveOneToThreeNumbers) {
  const auto file =
      scene::parse_obj("a.obj", kCorners + "vt 0.25\nvt 0.5 0.75\nvt 1 0.5 0.125\nf 1/1/1 2/2/1 3/3/1\n");
  EXPECT_EQ(file.mesh.uvs, (std::vector<Vec2f>{{0.25F, 0}, {0.5F, 0.75F}, {1, 0.5F}}));
  EXPECT_NE(refusal(kCorners + "vt\n").find("a.obj:5: expected one to three numbers"), std::string::npos);
}

TEST(ObjFile, OnlyTheWeightOneIsAPlace) {
  expect_as_the_triangle("v 0 0 0 1\nv 1 0 0 1.0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n");
  expect_as_the_triangle("v 0 0 0 0.5 0.2 1\nv 1 0 0 1 1 1\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n");
  EXPECT_NE(refusal("v 0 0 0 2\n" + kTriangle).find("a.obj:1: the weight w is 2; only 1 is read"),
            std::string::npos);
}

TEST(ObjFile, LinesEndAsOnAnySystem) {
  for (const char* end : {"\r", "\r\n"}) {
    std::string text;
    for (const char c : kTriangle) text += c == '\n' ? std::string(end) : std::string(1, c);
    expect_as_the_triangle(text);
  }
}

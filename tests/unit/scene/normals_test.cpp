// Mesh files without normals, and PLY in big-endian.
#include "base/error.h"
#include "scene/geometry/crease_normals.h"
#include "scene/geometry/obj.h"
#include "scene/geometry/ply.h"
#include "scene/load/load_scene.h"
#include "structure/source_files.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <gtest/gtest.h>

using namespace orbs;

namespace {

void append_big(std::string& out, float value) {
  auto bytes = std::bit_cast<std::array<char, 4>>(value);
  std::reverse(bytes.begin(), bytes.end());
  out.append(bytes.data(), bytes.size());
}
void append_big(std::string& out, std::uint32_t value) { append_big(out, std::bit_cast<float>(value)); }

// A roof of two squares that meet along x = 0 at `rise` above their outer edges, with no vertex shared.
std::string roof_obj(float rise) {
  return fmt::format(
      "v -1 0 0\nv -1 0 1\nv 0 {0} 1\nv 0 {0} 0\nv 0 {0} 0\nv 0 {0} 1\nv 1 0 1\nv 1 0 0\nf 1 2 3 4\nf 5 6 7 8\n",
      rise);
}

scene::Mesh roof(float rise, double crease_deg) {
  auto mesh = scene::parse_obj("roof.obj", roof_obj(rise), scene::FileNormals::MayLack).mesh;
  scene::compute_normals(mesh, crease_deg);
  return mesh;
}

std::string scene_text(const std::string& mesh) {
  return R"({"format": "orbs-scene/1", "name": "s", "camera": {"position": [0, 0, 5], "look_at": [0, 0, 0]},
"materials": [{"name": "m", "type": "lambert", "reflectance": [0.5, 0.5, 0.5]}],
"meshes": [{"name": "a", "material": "m", )" +
         mesh + "}]}";
}

std::string refusal(const std::string& mesh, const std::filesystem::path& folder) {
  try {
    scene::load_scene_text("scene.json", scene_text(mesh), folder);
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

}  // namespace

TEST(Ply, BigEndianReadsAsLittleEndian) {
  std::string bytes =
      "ply\nformat binary_big_endian 1.0\nelement vertex 3\n"
      "property float x\nproperty float y\nproperty float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
      "element face 1\nproperty list uchar uint vertex_indices\nend_header\n";
  for (const float x : {0.0F, 0.5F, 0.0F, 0.0F, 0.0F, 1.0F, 1.5F, 0.25F, -3.0F, 0.0F, 0.0F, 1.0F, 0.0F, 1e-7F,
                        12345.678F, 0.0F, 0.0F, 1.0F})
    append_big(bytes, x);
  bytes.push_back(3);
  for (const std::uint32_t i : {2U, 0U, 1U}) append_big(bytes, i);
  const auto mesh = scene::parse_ply("a.ply", bytes).mesh;
  EXPECT_EQ(mesh.positions[1], (Vec3f{1.5F, 0.25F, -3}));
  EXPECT_EQ(mesh.positions[2], (Vec3f{0, 1e-7F, 12345.678F}));
  EXPECT_EQ(mesh.triangles[0], (std::array<std::uint32_t, 3>{2, 0, 1}));
}

TEST(CreaseNormals, EdgesBelowTheAngleAreSmooth) {
  // The planes of the roof are turned against each other by 2 atan(0.5) = 53.13 degrees.
  const auto smooth = roof(0.5F, 60);
  ASSERT_EQ(smooth.positions.size(), 8U);
  for (std::size_t i = 0; i < 8; ++i) {
    const bool is_ridge = smooth.positions[i].x == 0;
    const float side = smooth.positions[i].x < 0 ? -1.0F : 1.0F;
    const Vec3f expected = is_ridge ? Vec3f{0, 1, 0} : normalised(Vec3f{side * 0.5F, 1, 0});
    EXPECT_LT(length(smooth.normals[i] - expected), 1e-6F) << i;
  }
}

TEST(CreaseNormals, EdgesAboveTheAngleAreSharp) {
  const auto sharp = roof(0.5F, 50);
  for (std::size_t i = 0; i < 8; ++i) {
    const float side = i < 4 ? -1.0F : 1.0F;
    EXPECT_LT(length(sharp.normals[i] - normalised(Vec3f{side * 0.5F, 1, 0})), 1e-6F) << i;
  }
}

// The corner of a cube whose faces share their vertices: at 30 degrees each vertex becomes three.
TEST(CreaseNormals, VerticesWithSeveralNormalsAreSplit) {
  const std::string cube =
      "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
      "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  auto mesh = scene::parse_obj("cube.obj", cube, scene::FileNormals::MayLack).mesh;
  auto round = mesh;
  scene::compute_normals(mesh, 30);
  EXPECT_EQ(mesh.positions.size(), 24U);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (const auto corner : mesh.triangles[i]) {
      EXPECT_NEAR(largest_magnitude(mesh.normals[corner]), 1, 1e-6);
      EXPECT_GT(dot(mesh.normals[corner], mesh.positions[corner]), 0);  // outwards
    }
  scene::compute_normals(round, 180);
  EXPECT_EQ(round.positions.size(), 8U);
  // Weighted by angles, the three faces count alike however they are cut into triangles.
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_LT(length(round.normals[i] - normalised(round.positions[i])), 1e-6F) << i;
}

TEST(CreaseNormals, TheSceneSaysWhetherTheyAreComputed) {
  const structure::TestFolder folder("normals");
  folder.write("roof.obj", roof_obj(0.5F));
  folder.write("with.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 1 0\nf 1//1 2//1 3//1\n");
  folder.write("mixed.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 1 0\nf 1//1 2//1 3//1\nf 1 2 3\n");
  const auto expect_part = [&](const std::string& mesh, const std::string& part) {
    const auto text = refusal(mesh, folder.path());
    EXPECT_NE(text.find(part), std::string::npos) << mesh << ": " << text;
  };
  for (const char* file : {"roof.obj", "with.obj", "mixed.obj"})
    EXPECT_EQ(refusal(fmt::format(R"("file": "{}", "crease_angle": 30)", file), folder.path()), "no error");
  expect_part(R"("file": "roof.obj")", "\"crease_angle\" in the scene has them computed");
  expect_part(R"("file": "mixed.obj")", "mixed.obj:6: each corner needs a normal");
  expect_part(R"("file": "with.obj", "crease_angle": 30, "given_normals": "keep")",
              "given_normals: the file has all normals");
  expect_part(R"("file": "with.obj", "given_normals": "keep")",
              "given_normals: goes with the \"crease_angle\" of a file");
  expect_part(R"("file": "roof.obj", "crease_angle": 181)", "must lie in [0, 180]");
}

namespace {

scene::Mesh mesh_of(const std::string& file, const std::string& text, const std::string& keys) {
  const structure::TestFolder folder("given-normals");
  folder.write(file, text);
  const auto scene = scene::load_scene_text(
      "scene.json", scene_text(fmt::format(R"("file": "{}", {})", file, keys)), folder.path());
  return scene.meshes.at(0);
}

// A triangle and one without area, whose normals programs write as zero; one corner has no normal.
const std::string kDegenerate =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nvn 0 0.6 0.8\nvn 0 0 0\nvn nan 0 1\n"
    "f 1//1 2//1 3\nf 4//2 4//2 1//1\nf 1//3 2//1 3//1\n";

}  // namespace

TEST(CreaseNormals, ReplaceAllNormalsOfAFile) {
  const auto mesh = mesh_of("a.obj", kDegenerate, R"("crease_angle": 30)");
  for (const Vec3f normal : mesh.normals) EXPECT_EQ(normal, (Vec3f{0, 0, 1}));
}

TEST(CreaseNormals, OrFillInThoseThatCannotBeUsed) {
  const auto mesh = mesh_of("a.obj", kDegenerate, R"("crease_angle": 30, "given_normals": "keep")");
  const auto normal = [&](std::size_t triangle, std::size_t corner) {
    return mesh.normals[mesh.triangles[triangle][corner]];
  };
  EXPECT_EQ(normal(0, 0), (Vec3f{0, 0.6F, 0.8F}));
  EXPECT_EQ(normal(0, 1), (Vec3f{0, 0.6F, 0.8F}));
  EXPECT_EQ(normal(0, 2), (Vec3f{0, 0, 1})) << "absent";
  EXPECT_EQ(normal(1, 0), (Vec3f{0, 0, 1})) << "zero";
  EXPECT_EQ(normal(1, 2), (Vec3f{0, 0.6F, 0.8F}));
  EXPECT_EQ(normal(2, 0), (Vec3f{0, 0, 1})) << "not finite";
}

TEST(CreaseNormals, AreMissedWhereTheCornerStands) {
  const auto error = [](const std::string& file, const std::string& text) -> std::string {
    try {
      mesh_of(file, text, R"("wrong_key": 0)");
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  };
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "property float nx\nproperty float ny\nproperty float nz\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0 0 0 1\n1 0 0 0 0 0\n0 1 0 0 0 1\n3 0 1 2\n";
  const std::string hint = "must be finite and not zero; \"crease_angle\" in the scene has normals computed";
  const auto of_obj = error("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvn 0 0 0\nf 1//1 2//2 3//1\n");
  EXPECT_NE(of_obj.find("a.obj:6: normal 2 is (0, 0, 0), " + hint), std::string::npos) << of_obj;
  const auto of_ply = error("a.ply", ply);
  EXPECT_NE(of_ply.find("a.ply:14: vertex 1: the normal is (0, 0, 0), " + hint), std::string::npos) << of_ply;
  EXPECT_EQ(mesh_of("a.ply", ply, R"("crease_angle": 30)").normals[1], (Vec3f{0, 0, 1}));
}

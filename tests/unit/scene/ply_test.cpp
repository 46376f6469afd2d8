// Forms of PLY files that programs write, and messages that say where they are wrong.
#include "scene/geometry/ply.h"

#include "base/error.h"

#include <bit>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace {

using namespace orbs;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

struct PlyText {
  std::string vertex_properties = "";  // beside positions and normals
  std::vector<std::string> rows{"", "", "", ""};
  std::string face_properties = "";
  std::vector<std::string> faces{"3 0 1 2", "3 0 2 3"};
};

// A square of half size 1 in ASCII; the first row of vertices stands in line 13 if there are no further
// properties.
std::string square(const PlyText& text) {
  std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 4\n"
      "property float x\nproperty float y\nproperty float z\n"
      "property float nx\nproperty float ny\nproperty float nz\n" +
      text.vertex_properties + fmt::format("element face {}\n", text.faces.size()) +
      "property list uchar int vertex_indices\n" + text.face_properties + "end_header\n";
  constexpr std::array kCorners{"-1 -1 0", "1 -1 0", "1 1 0", "-1 1 0"};
  for (std::size_t i = 0; i < 4; ++i) ply += fmt::format("{} 0 0 1 {}\n", kCorners.at(i), text.rows[i]);
  for (const auto& face : text.faces) ply += face + "\n";
  return ply;
}

std::string with_uvs(const std::string& u, const std::string& v, const std::string& more = "") {
  return square({fmt::format("property float {}\nproperty float {}\n{}", u, v, more),
                 more.empty() ? std::vector<std::string>{"0 0", "1 0", "1 1", "0 1"}
                              : std::vector<std::string>{"0 0 9", "1 0 9", "1 1 9", "0 1 9"}});
}

std::string refusal(const std::string& text) {
  try {
    scene::parse_ply("a.ply", text);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

void expect_part(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in: " << text;
}

const std::vector<Vec2f> kSquareUvs{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

}  // namespace

TEST(Ply, TextureCoordinatesAreReadByAllTheirNames) {
  for (const auto& [u, v] : std::vector<std::pair<const char*, const char*>>{{"u", "v"},
                                                                             {"s", "t"},
                                                                             {"texture_u", "texture_v"},
                                                                             {"texture_s", "texture_t"},
                                                                             {"u0", "v0"},
                                                                             {"s0", "t0"},
                                                                             {"texcoord_u", "texcoord_v"},
                                                                             {"tex_u", "tex_v"},
                                                                             {"tu", "tv"},
                                                                             {"tx", "ty"}})
    EXPECT_EQ(scene::parse_ply("a.ply", with_uvs(u, v)).mesh.uvs, kSquareUvs) << u;
}

TEST(Ply, TangentsAreNoTextureCoordinates) {
  const auto mesh = scene::parse_ply("a.ply", with_uvs("tx", "ty", "property float tz\n")).mesh;
  EXPECT_EQ(mesh.uvs, std::vector<Vec2f>(4));
  EXPECT_EQ(mesh.tangents[1], (Vec3f{1, 0, 9}));
  EXPECT_EQ(scene::parse_ply("a.ply", with_uvs("tx", "ty")).mesh.tangents, std::vector<Vec3f>(4));
}

TEST(Ply, HalfAPairOfNamesIsNone) {
  EXPECT_EQ(scene::parse_ply("a.ply", with_uvs("u", "time")).mesh.uvs, std::vector<Vec2f>(4));
}

TEST(Ply, TextureCoordinatesOfFacesSplitVertices) {
  const auto mesh =
      scene::parse_ply("a.ply", square({"",
                                        {"", "", "", ""},
                                        "property list uchar float texcoord\n",
                                        {"3 0 1 2 6 0 0 1 0 1 1", "3 0 2 3 6 0.5 0.5 1 1 0 1"}}))
          .mesh;
  ASSERT_EQ(mesh.positions.size(), 5U);
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {4, 2, 3}}));
  EXPECT_EQ(mesh.uvs, (std::vector<Vec2f>{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5F, 0.5F}}));
  EXPECT_EQ(mesh.positions[4], mesh.positions[0]);
  EXPECT_EQ(mesh.normals[4], mesh.normals[0]);
  EXPECT_EQ(mesh.tangents.size(), 5U);
}

TEST(Ply, FacesWithoutTextureCoordinatesHaveThoseOfTheVertices) {
  const auto mesh = scene::parse_ply("a.ply", square({"property float s\nproperty float t\n",
                                                      {"0 0", "1 0", "1 1", "0 1"},
                                                      "property list uchar float texcoord\n",
                                                      {"3 0 1 2 0", "4 0 1 2 3 8 5 5 6 5 6 6 5 6"}}))
                        .mesh;
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {4, 5, 6}, {4, 6, 3}}));
  EXPECT_EQ(mesh.uvs, (std::vector<Vec2f>{{0, 0}, {1, 0}, {1, 1}, {5, 6}, {5, 5}, {6, 5}, {6, 6}}));
}

TEST(Ply, TextureCoordinatesOfFacesArePairs) {
  expect_part(refusal(square({"",
                              {"", "", "", ""},
                              "property list uchar float texcoord\n",
                              {"3 0 1 2 6 0 0 1 0 1 1", "3 0 2 3 4 0.5 0.5 1 1"}})),
              "a.ply:19: face 1: the list 'texcoord' has 4 numbers, expected u and v of 3 corners");
}

TEST(Ply, CutsAConcaveFaceAtItsConcaveCorner) {
  const std::string dart =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "2 0 0\n0.5 0.5 0\n0 2 0\n0 0 0\n4 0 1 2 3\n";
  const auto mesh = scene::parse_ply("a.ply", dart, scene::FileNormals::MayLack).mesh;
  double area = 0;
  for (const auto& t : mesh.triangles) {
    const auto at = [&](std::size_t k) { return cast<double>(mesh.positions[t[k]]); };
    area += length(cross(at(1) - at(0), at(2) - at(0))) / 2;
  }
  EXPECT_DOUBLE_EQ(area, 1);
}

TEST(Ply, KeepsTheFanOfAConvexFaceAndWarnsOfCrossings) {
  EXPECT_EQ(scene::parse_ply("a.ply", square({.faces = {"4 0 1 2 3"}})).mesh.triangles,
            (Triangles{{0, 1, 2}, {0, 2, 3}}));
  const auto crossing = scene::parse_ply("a.ply", square({.faces = {"4 0 1 2 3", "4 0 2 1 3"}}));
  EXPECT_EQ(crossing.mesh.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}, {0, 2, 1}, {0, 1, 3}}));
  ASSERT_EQ(crossing.warnings.size(), 1U);
  expect_part(crossing.warnings[0], "a.ply:18: face 1: edges of this face cross");
}

TEST(Ply, MessagesSayTheRowAndInAsciiTheLine) {
  expect_part(refusal(square({.faces = {"3 0 1 2", "0"}})),
              "a.ply:18: face 1: a face needs at least three corners, has 0");
  expect_part(refusal(square({.faces = {"3 0 1 4"}})),
              "a.ply:17: face 0: vertex index 4 is out of range: there are 4, counted from 0");
  expect_part(refusal(square({.faces = {"3 0 1 2", "3 0 1.5 2"}})),
              "a.ply:18: face 1: vertex index 1.5 is out of range");
  expect_part(refusal(square({.faces = {"3 0 one 2"}})), "a.ply:17: face 0: 'one' is not a number");
  expect_part(refusal(square({"", {"", "nonsense", "", ""}})),
              "a.ply:14: vertex 2: 'nonsense' is not a number");
  auto torn = square({});
  torn.resize(torn.size() - 4);
  expect_part(refusal(torn), "a.ply:18: face 1: the file ends within its data");
}

TEST(Ply, MessagesAboutBinaryDataSayTheRow) {
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
      "property float nx\nproperty float ny\nproperty float nz\n"
      "element face 2\nproperty list uchar uchar vertex_indices\nend_header\n";
  for (const float x : {0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 1.0F}) {
    const auto four = std::bit_cast<std::array<char, 4>>(x);
    bytes.append(four.data(), four.size());
  }
  const std::string face(3, '\0');
  const auto three = std::string(1, '\3') + face;
  EXPECT_EQ(refusal(bytes + three + three), "");
  EXPECT_EQ(refusal(bytes + three + std::string(1, '\2') + face),
            "a.ply: face 1: a face needs at least three corners, has 2");
  EXPECT_EQ(refusal(bytes + three + "\3"), "a.ply: face 1: the file ends within its data");
}

TEST(Ply, MessagesAboutTheHeaderSayTheLine) {
  expect_part(refusal("ply\nformat ascii 1.0\nelement vertex 3\nproperty half x\n"),
              "a.ply:4: property type 'half' is unknown");
  expect_part(refusal("ply\nformat ascii 1.0\nelemnt vertex 3\n"),
              "a.ply:3: header line that starts with 'elemnt' is not understood");
}

TEST(Ply, TriangleStripsAreNamed) {
  expect_part(
      refusal(
          "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
          "property float nx\nproperty float ny\nproperty float nz\n"
          "element tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0 0 0 1\n3 0 0 0\n"),
      "a.ply: there is no face in the file; its elements are: vertex, tristrips. Triangle strips "
      "(tristrips) are not read: write faces");
}

TEST(Ply, BlankHeaderLinesAndAllLineEndsAreRead) {
  const auto text = square({});
  const auto mesh = scene::parse_ply("a.ply", text).mesh;
  auto blank = text;
  blank.insert(4, "\n  \ncomment\n\n");
  EXPECT_EQ(scene::parse_ply("a.ply", blank).mesh, mesh);
  for (const char* end : {"\r", "\r\n"}) {
    std::string other;
    for (const char c : text) other += c == '\n' ? std::string(end) : std::string(1, c);
    EXPECT_EQ(scene::parse_ply("a.ply", other).mesh, mesh);
    expect_part(refusal(other.substr(0, other.size() - 6)), "a.ply:18: face 1");
  }
}

TEST(Ply, FacesMayStandBeforeTheirVertices) {
  const auto mesh =
      scene::parse_ply("a.ply",
                       "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\n"
                       "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
                       "3 2 0 1\n0 0 0\n1 0 0\n0 1 0\n",
                       scene::FileNormals::MayLack)
          .mesh;
  EXPECT_EQ(mesh.triangles, (Triangles{{2, 0, 1}}));
}

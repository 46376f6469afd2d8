// A PLY file says the same in text, in little-endian and in big-endian, whatever the types of its properties.
#include "scene/geometry/generators.h"
#include "scene/geometry/ply.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#include <gtest/gtest.h>

using namespace orbs;

namespace {

enum class Form { Ascii, LittleEndian, BigEndian };

// Appends numbers of a PLY file in one of its three forms.
class Numbers {
 public:
  explicit Numbers(Form form) : form_(form) {}

  template <typename T>
  void add(T value) {
    if (form_ == Form::Ascii) {
      text_ +=
          fmt::format("{:.17g} ", static_cast<double>(value));  // what a reader needs to get the same bits
      return;
    }
    auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
    if (form_ == Form::BigEndian) std::reverse(bytes.begin(), bytes.end());
    text_.append(bytes.data(), bytes.size());
  }
  void end_row() {
    if (form_ == Form::Ascii) text_ += '\n';
  }
  const std::string& text() const { return text_; }

 private:
  Form form_;
  std::string text_;
};

// Each type of number occurs, in properties that are read and in some that are not; the places lie so far out
// that doubles are needed to tell them.
std::string ply_of(const scene::Mesh& mesh, Form form) {
  const char* words[] = {"ascii", "binary_little_endian", "binary_big_endian"};
  std::string header = fmt::format("ply\nformat {} 1.0\nelement vertex {}\n", words[static_cast<int>(form)],
                                   mesh.positions.size());
  for (const char* property :
       {"uchar red", "double x", "double y", "double z", "short step", "float nx", "float ny", "float nz",
        "char sign", "float tx", "float ty", "float tz", "double u", "float v", "int age"})
    header += fmt::format("property {}\n", property);
  header += fmt::format(
      "element face {}\nproperty ushort material\nproperty list ushort uint vertex_indices\n"
      "property list uchar float weights\nend_header\n",
      mesh.triangles.size());
  Numbers numbers(form);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const auto& [p, n, t] = std::tie(mesh.positions[i], mesh.normals[i], mesh.tangents[i]);
    numbers.add(static_cast<std::uint8_t>(i));
    for (const float x : {p.x, p.y, p.z}) numbers.add(1e6 / 3 + static_cast<double>(x));
    numbers.add(static_cast<std::int16_t>(-300 - static_cast<int>(i)));
    for (const float x : {n.x, n.y, n.z}) numbers.add(x);
    numbers.add(static_cast<std::int8_t>(-1));
    for (const float x : {t.x, t.y, t.z}) numbers.add(x);
    numbers.add(static_cast<double>(mesh.uvs[i].x) / 3);
    numbers.add(mesh.uvs[i].y);
    numbers.add(static_cast<std::int32_t>(-70000));
    numbers.end_row();
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    numbers.add(static_cast<std::uint16_t>(i % 700));
    numbers.add(std::uint16_t{3});
    for (const std::uint32_t corner : mesh.triangles[i]) numbers.add(corner);
    numbers.add(std::uint8_t{2});
    for (const float weight : {0.1F, -1e-30F}) numbers.add(weight);
    numbers.end_row();
  }
  return header + numbers.text();
}

}  // namespace

TEST(Ply, AWholeFileIsTheSameInTextAndInEitherByteOrder) {
  const auto torus = scene::make_torus({0.3, 1, 24, 16});
  const auto text = scene::parse_ply("torus.ply", ply_of(torus, Form::Ascii));
  ASSERT_EQ(text.mesh.positions.size(), torus.positions.size());
  ASSERT_EQ(text.mesh.triangles, torus.triangles);
  EXPECT_EQ(text.mesh.normals, torus.normals);
  EXPECT_EQ(text.mesh.triangle_materials.back(), static_cast<int>((torus.triangles.size() - 1) % 700));
  EXPECT_NE(text.origin_m, Vec3d{}) << "the test is to need doubles";
  for (const Form form : {Form::LittleEndian, Form::BigEndian}) {
    const auto binary = scene::parse_ply("torus.ply", ply_of(torus, form));
    EXPECT_EQ(binary.mesh, text.mesh) << static_cast<int>(form);
    EXPECT_EQ(binary.origin_m, text.origin_m) << static_cast<int>(form);
  }
}

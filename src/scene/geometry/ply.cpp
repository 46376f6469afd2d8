#include "scene/geometry/ply.h"

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "scene/geometry/corner_uvs.h"
#include "scene/geometry/ply_header.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::scene {

namespace {

static_assert(std::endian::native == std::endian::little,
              "binary PLY is written without swapping bytes, and read with swapping those of big-endian");

template <typename T>
double as_number(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return static_cast<double>(value);
}

double number_from_bytes(const char* bytes, const std::string& type) {
  if (type == "char" || type == "int8") return as_number<std::int8_t>(bytes);
  if (type == "uchar" || type == "uint8") return as_number<std::uint8_t>(bytes);
  if (type == "short" || type == "int16") return as_number<std::int16_t>(bytes);
  if (type == "ushort" || type == "uint16") return as_number<std::uint16_t>(bytes);
  if (type == "int" || type == "int32") return as_number<std::int32_t>(bytes);
  if (type == "uint" || type == "uint32") return as_number<std::uint32_t>(bytes);
  if (type == "double" || type == "float64") return as_number<double>(bytes);
  return as_number<float>(bytes);
}

// Texture coordinates of vertices by the names that programs give them; where a file has several pairs, the
// first of these. tx and ty with tz are tangents.
using NamePair = std::pair<const char*, const char*>;
constexpr std::array<NamePair, 10> kUvNames{{{"u", "v"},
                                             {"s", "t"},
                                             {"texture_u", "texture_v"},
                                             {"texture_s", "texture_t"},
                                             {"u0", "v0"},
                                             {"s0", "t0"},
                                             {"texcoord_u", "texcoord_v"},
                                             {"tex_u", "tex_v"},
                                             {"tu", "tv"},
                                             {"tx", "ty"}}};

// Empty names where there are none.
NamePair uv_names(const PlyElement& vertices) {
  for (const auto& [u, v] : kUvNames)
    if (has_property(vertices, u) && has_property(vertices, v) &&
        (std::string_view(u) != "tx" || !has_property(vertices, "tz")))
      return {u, v};
  return {"", ""};
}

class PlyReader {
 public:
  PlyReader(const std::string& name, std::string_view bytes, FileNormals normals)
      : name_(name), text_(bytes), normals_(normals), header_(parse_ply_header(name, bytes)) {}

  MeshFile read() {
    at_ = header_.bytes;
    for (const auto& element : header_.elements) read_element(element);
    element_.clear();
    if (faces_.sizes.empty()) fail(no_faces_problem());
    check_corners();
    split_by_uvs(corner_uvs_, faces_.corners, places_, out_.mesh);
    place_vertices(places_, out_);
    add_triangles(
        faces_, [this](std::size_t i) { return place("face", i, face_at_[i]); }, out_);
    out_.names_are_slots = true;
    return std::move(out_);
  }

 private:
  using Row = std::map<std::string, std::vector<double>>;

  void read_element(const PlyElement& element) {
    values_.clear();
    element_.clear();
    if (element.name == "vertex") start_vertices(element);
    if (element.name == "face") start_faces(element);
    element_ = element.name;
    for (row_ = 0; row_ < element.count; ++row_) {
      row_at_ = at_;
      read_row(element);
      if (element.name == "vertex") read_vertex();
      if (element.name == "face") read_face();
    }
  }

  std::string no_faces_problem() const {
    std::vector<std::string> names;
    for (const auto& element : header_.elements) names.push_back(element.name);
    const bool has_strips = std::find(names.begin(), names.end(), "tristrips") != names.end();
    return fmt::format("there is no face in the file; its elements are: {}{}", fmt::join(names, ", "),
                       has_strips ? ". Triangle strips (tristrips) are not read: write faces" : "");
  }

  double next_binary_number(const std::string& type) {
    const std::size_t size = ply_bytes_of(type);
    if (at_ + size > text_.size()) fail("the file ends within its data");
    std::array<char, 8> bytes{};  // the largest type has eight
    for (std::size_t i = 0; i < size && i < bytes.size(); ++i)
      bytes[i] = text_[at_ + (header_.encoding == PlyEncoding::BigEndian ? size - 1 - i : i)];
    at_ += size;
    return number_from_bytes(bytes.data(), type);
  }

  double next_number(const std::string& type) {
    if (header_.encoding != PlyEncoding::Ascii) return next_binary_number(type);
    at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size());
    if (at_ == text_.size()) fail("the file ends within its data");
    const auto end = std::min(text_.find_first_of(" \t\r\n", at_), text_.size());
    const auto value = to_number(text_.substr(at_, end - at_));
    if (!value) fail(fmt::format("'{}' is not a number", text_.substr(at_, end - at_)));
    at_ = end;
    return *value;
  }

  void read_row(const PlyElement& element) {
    for (const auto& property : element.properties) {
      double count = property.count_type.empty() ? 1 : next_number(property.count_type);
      auto& values = values_[property.name];
      values.clear();
      for (; count > 0; --count) values.push_back(next_number(property.type));
    }
  }

  // 0 where vertices have no such property.
  double value(const char* name) const {
    const auto found = values_.find(name);
    if (found == values_.end()) return 0;
    if (found->second.empty()) fail(fmt::format("the list '{}' is empty, expected a number", name));
    return found->second.front();
  }

  Vec3f rounded(const char* x, const char* y, const char* z) const {
    return cast<float>(Vec3d{value(x), value(y), value(z)});
  }

  void start_vertices(const PlyElement& element) {
    for (const char* name : {"x", "y", "z", "nx", "ny", "nz"}) {
      const bool is_normal = *name == 'n';
      if (has_property(element, name) || (is_normal && normals_ == FileNormals::MayLack)) continue;
      fail(fmt::format("vertices lack the property '{}'{}", name,
                       is_normal ? "; \"crease_angle\" in the scene has normals computed" : ""));
    }
    uv_names_ = uv_names(element);
    has_second_uvs_ = has_property(element, "u2") && has_property(element, "v2");
    has_tangents_ = std::string_view(uv_names_.first) != "tx";
  }

  void read_vertex() {
    Mesh& mesh = out_.mesh;
    places_.push_back({value("x"), value("y"), value("z")});
    mesh.normals.push_back(rounded("nx", "ny", "nz"));
    mesh.tangents.push_back(has_tangents_ ? rounded("tx", "ty", "tz") : Vec3f{});
    mesh.uvs.push_back(
        {static_cast<float>(value(uv_names_.first)), static_cast<float>(value(uv_names_.second))});
    if (has_second_uvs_)
      mesh.second_uvs.push_back({static_cast<float>(value("u2")), static_cast<float>(value("v2"))});
    if (const Vec3f n = mesh.normals.back(); normals_ == FileNormals::Required && !is_direction(n))
      fail(fmt::format(
          "the normal is ({}, {}, {}), must be finite and not zero; \"crease_angle\" in the scene "
          "has normals computed",
          n.x, n.y, n.z));
  }

  void start_faces(const PlyElement& element) {
    indices_ = has_property(element, "vertex_indices") ? "vertex_indices" : "vertex_index";
    if (!has_property(element, indices_)) fail("faces lack the list 'vertex_indices'");
  }

  void read_face() {
    const auto& corners = values_.at(indices_);
    const auto material = values_.find("material");
    for (const double corner : corners)
      if (!(corner >= 0 && corner < 4294967296.0 && corner == std::floor(corner)))
        fail(fmt::format("vertex index {} is out of range or no whole number", corner));
    if (corners.size() < 3) fail(fmt::format("a face needs at least three corners, has {}", corners.size()));
    for (const double corner : corners) faces_.corners.push_back(static_cast<std::uint32_t>(corner));
    faces_.sizes.push_back(static_cast<std::uint32_t>(corners.size()));
    faces_.materials.push_back(material == values_.end() ? -1 : slot(material->second));
    face_at_.push_back(row_at_);
    add_corner_uvs(corners.size());
  }

  int slot(const std::vector<double>& numbers) const {
    if (numbers.size() != 1) fail(fmt::format("a face has {} materials, expected one", numbers.size()));
    const double number = numbers.front();
    if (!(number >= 0 && number < 2147483648.0 && number == std::floor(number)))
      fail(fmt::format("material {} is no place in a list", number));
    return static_cast<int>(number);
  }

  // "texcoord" as MeshLab writes it: u and v of each corner, or nothing.
  void add_corner_uvs(std::size_t corners) {
    const auto found = values_.find("texcoord");
    if (found == values_.end() || found->second.empty()) return;
    const auto& numbers = found->second;
    if (numbers.size() != 2 * corners)
      fail(fmt::format("the list 'texcoord' has {} numbers, expected u and v of {} corners", numbers.size(),
                       corners));
    corner_uvs_.resize(faces_.corners.size() - corners);
    for (std::size_t i = 0; i < numbers.size(); i += 2)
      corner_uvs_.push_back(Vec2f{static_cast<float>(numbers[i]), static_cast<float>(numbers[i + 1])});
  }

  // Faces may stand before the vertices.
  void check_corners() {
    element_ = "face";
    const std::uint32_t* corner = faces_.corners.data();
    for (row_ = 0; row_ < faces_.sizes.size(); ++row_)
      for (std::uint32_t k = 0; k < faces_.sizes[row_]; ++k, ++corner) {
        row_at_ = face_at_[row_];
        if (*corner >= places_.size())
          fail(fmt::format("vertex index {} is out of range: there are {}, counted from 0", *corner,
                           places_.size()));
      }
  }

  // "mesh.ply:15: face 3", rows counted from 0 as PLY does; binary files have no lines.
  std::string place(const std::string& element, std::size_t row, std::size_t at) const {
    if (header_.encoding != PlyEncoding::Ascii) return fmt::format("{}: {} {}", name_, element, row);
    at = std::min(text_.find_first_not_of(" \t\r\n", at), text_.size());
    const auto before = text_.substr(0, at);
    const char end = before.find('\n') == std::string_view::npos ? '\r' : '\n';
    return fmt::format("{}:{}: {} {}", name_, 1 + std::count(before.begin(), before.end(), end), element,
                       row);
  }

  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError(
        fmt::format("{}: {}", element_.empty() ? name_ : place(element_, row_, row_at_), problem));
  }

  std::string name_;
  std::string_view text_;
  FileNormals normals_;
  PlyHeader header_;
  std::size_t at_ = 0;
  std::string element_;  // of which a row is read; empty between elements
  std::size_t row_ = 0;
  std::size_t row_at_ = 0;  // where the row begins
  Row values_;              // of the row, by the names of properties
  NamePair uv_names_;
  bool has_tangents_ = true;
  bool has_second_uvs_ = false;
  std::string indices_;
  std::vector<Vec3d> places_;  // of the vertices
  Polygons faces_;
  std::vector<std::size_t> face_at_;  // where each face begins
  CornerUvs corner_uvs_;
  MeshFile out_;
};

template <typename T>
void append(std::string& out, T value) {
  const auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
  out.append(bytes.data(), bytes.size());
}

void append(std::string& out, Vec3f v) {
  for (const float x : {v.x, v.y, v.z}) append(out, x);
}

}  // namespace

MeshFile parse_ply(const std::string& name, std::string_view bytes, FileNormals normals) {
  return PlyReader(name, bytes, normals).read();
}

MeshFile read_ply(const std::filesystem::path& file, FileNormals normals) {
  return parse_ply(file.string(), read_file(file), normals);
}

void write_ply(const Mesh& mesh, const std::filesystem::path& file, PlyContent content) {
  const bool everything = content == PlyContent::Everything;
  std::string out = "ply\nformat binary_little_endian 1.0\n";
  out += fmt::format("element vertex {}\n", mesh.positions.size());
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz", "tx", "ty", "tz", "u", "v"})
    if (everything || *name != 't') out += fmt::format("property float {}\n", name);
  const bool has_second_uvs = everything && !mesh.second_uvs.empty();
  if (has_second_uvs) out += "property float u2\nproperty float v2\n";
  out += fmt::format("element face {}\nproperty list uchar uint vertex_indices\n{}end_header\n",
                     mesh.triangles.size(), everything ? "property int material\n" : "");
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    append(out, mesh.positions[i]);
    append(out, mesh.normals[i]);
    if (everything) append(out, mesh.tangents[i]);
    append(out, mesh.uvs[i].x);
    append(out, mesh.uvs[i].y);
    if (!has_second_uvs) continue;
    append(out, mesh.second_uvs[i].x);
    append(out, mesh.second_uvs[i].y);
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    append(out, std::uint8_t{3});
    for (const std::uint32_t corner : mesh.triangles[i]) append(out, corner);
    if (everything) append(out, std::int32_t{mesh.triangle_materials[i]});
  }
  write_file(file, out);
}

}  // namespace orbs::scene

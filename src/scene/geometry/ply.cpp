#include "scene/geometry/ply.h"

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>

#include <fmt/format.h>

namespace orbs::scene {

namespace {

static_assert(std::endian::native == std::endian::little,
              "binary PLY is written without swapping bytes, and read with swapping those of big-endian");

enum class Encoding { Ascii, LittleEndian, BigEndian };

struct Property {
  std::string name;
  std::string type;
  std::string count_type;  // of lists, else empty
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

std::size_t bytes_of(const std::string& type) {
  static const std::map<std::string, std::size_t> sizes{
      {"char", 1},  {"uchar", 1},   {"int8", 1},   {"uint8", 1},  {"short", 2}, {"ushort", 2},
      {"int16", 2}, {"uint16", 2},  {"int", 4},    {"uint", 4},   {"int32", 4}, {"uint32", 4},
      {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
  const auto found = sizes.find(type);
  return found == sizes.end() ? 0 : found->second;
}

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

class PlyReader {
 public:
  PlyReader(const std::string& name, std::string_view bytes, FileNormals normals)
      : name_(name), text_(bytes), normals_(normals) {}

  MeshFile read() {
    read_header();
    // Without this check a row would take no byte, and a short file could claim more rows than can be read in
    // a lifetime.
    for (const auto& element : elements_)
      if (element.properties.empty()) fail(fmt::format("element '{}' has no property", element.name));
    for (const auto& element : elements_) {
      if (element.name == "vertex")
        read_vertices(element);
      else if (element.name == "face")
        read_faces(element);
      else
        for (std::size_t i = 0; i < element.count; ++i) read_row(element);
    }
    if (out_.mesh.triangles.empty()) fail("there is no face in the file");
    out_.names_are_slots = true;
    return std::move(out_);
  }

 private:
  using Row = std::map<std::string, std::vector<double>>;

  std::string_view header_line() {
    const auto end = text_.find('\n', at_);
    if (end == std::string::npos) fail("the header has no end_header");
    const auto line = trim(text_.substr(at_, end - at_));
    at_ = end + 1;
    return line;
  }

  void read_header() {
    if (header_line() != "ply") fail("the file does not start with 'ply'");
    for (auto line = header_line(); line != "end_header"; line = header_line())
      read_header_words(words_of(line));
    if (!has_format_) fail("the header names no format");
  }

  void read_header_words(const std::vector<std::string>& words) {
    if (words.empty()) fail("a line of the header is empty");
    if (words[0] == "format" && words.size() == 3) {
      const auto found = encodings().find(words[1]);
      if (found == encodings().end())
        fail(fmt::format("format {} is not supported: use ascii, binary_little_endian or binary_big_endian",
                         words[1]));
      encoding_ = found->second;
      has_format_ = true;
    } else if (words[0] == "element" && words.size() == 3) {
      const auto count = to_integer(words[2]);
      // A row takes at least one byte, so a count larger than the file is wrong and must not allocate memory.
      if (!count || *count < 0 || static_cast<std::size_t>(*count) > text_.size())
        fail(fmt::format("element count '{}' is impossible", words[2]));
      elements_.push_back({words[1], static_cast<std::size_t>(*count), {}});
    } else if (words[0] == "property" && !elements_.empty() &&
               (words.size() == 3 || (words.size() == 5 && words[1] == "list"))) {
      const bool list = words.size() == 5;
      for (std::size_t i = list ? 2 : 1; i + 1 < words.size(); ++i)
        if (bytes_of(words[i]) == 0) fail(fmt::format("property type '{}' is unknown", words[i]));
      elements_.back().properties.push_back({words.back(), words[words.size() - 2], list ? words[2] : ""});
    } else if (words[0] != "comment" && words[0] != "obj_info") {
      fail(fmt::format("header line that starts with '{}' is not understood", words[0]));
    }
  }

  static const std::map<std::string, Encoding>& encodings() {
    static const std::map<std::string, Encoding> kEncodings{{"ascii", Encoding::Ascii},
                                                            {"binary_little_endian", Encoding::LittleEndian},
                                                            {"binary_big_endian", Encoding::BigEndian}};
    return kEncodings;
  }

  double next_binary_number(const std::string& type) {
    const std::size_t size = bytes_of(type);
    if (at_ + size > text_.size()) fail("the file ends within its data");
    std::array<char, 8> bytes{};  // the largest type has eight
    for (std::size_t i = 0; i < size && i < bytes.size(); ++i)
      bytes[i] = text_[at_ + (encoding_ == Encoding::BigEndian ? size - 1 - i : i)];
    at_ += size;
    return number_from_bytes(bytes.data(), type);
  }

  double next_number(const std::string& type) {
    if (encoding_ != Encoding::Ascii) return next_binary_number(type);
    at_ = text_.find_first_not_of(" \t\r\n", at_);
    if (at_ == std::string::npos) fail("the file ends within its data");
    const auto end = std::min(text_.find_first_of(" \t\r\n", at_), text_.size());
    const auto value = to_number(text_.substr(at_, end - at_));
    if (!value) fail(fmt::format("'{}' is not a number", text_.substr(at_, end - at_)));
    at_ = end;
    return *value;
  }

  const Row& read_row(const Element& element) {
    for (const auto& property : element.properties) {
      double count = property.count_type.empty() ? 1 : next_number(property.count_type);
      auto& values = row_[property.name];
      values.clear();
      for (; count > 0; --count) values.push_back(next_number(property.type));
    }
    return row_;
  }

  double value(const Row& row, std::initializer_list<const char*> names, bool is_required) const {
    for (const char* name : names)
      if (const auto found = row.find(name); found != row.end() && !found->second.empty())
        return found->second.front();
    if (is_required)
      fail(fmt::format("vertices lack the property '{}'{}", *names.begin(),
                       std::string_view(*names.begin()).starts_with('n')
                           ? "; \"crease_angle\" in the scene has normals computed"
                           : ""));
    return 0;
  }

  void read_vertices(const Element& element) {
    Mesh& mesh = out_.mesh;
    row_.clear();
    const bool has_normals = std::any_of(element.properties.begin(), element.properties.end(),
                                         [](const Property& property) { return property.name == "nx"; });
    out_.lacks_normals = !has_normals && normals_ == FileNormals::MayLack;
    std::vector<Vec3d> positions;
    for (std::size_t i = 0; i < element.count; ++i) {
      const Row& row = read_row(element);
      const auto rounded = [&](std::initializer_list<const char*> names, bool is_required) {
        return static_cast<float>(value(row, names, is_required));
      };
      positions.push_back({value(row, {"x"}, true), value(row, {"y"}, true), value(row, {"z"}, true)});
      const bool needs = !out_.lacks_normals;
      mesh.normals.push_back({rounded({"nx"}, needs), rounded({"ny"}, needs), rounded({"nz"}, needs)});
      mesh.tangents.push_back({rounded({"tx"}, false), rounded({"ty"}, false), rounded({"tz"}, false)});
      mesh.uvs.push_back({rounded({"u", "s"}, false), rounded({"v", "t"}, false)});
    }
    place_vertices(positions, out_);
  }

  void read_faces(const Element& element) {
    row_.clear();
    for (std::size_t i = 0; i < element.count; ++i) {
      const Row& row = read_row(element);
      auto found = row.find("vertex_indices");
      if (found == row.end()) found = row.find("vertex_index");
      if (found == row.end()) fail("faces lack the list 'vertex_indices'");
      const auto material = row.find("material");
      add_face(found->second, material == row.end() ? -1 : slot(material->second));
    }
  }

  int slot(const std::vector<double>& numbers) const {
    if (numbers.size() != 1) fail(fmt::format("a face has {} materials, expected one", numbers.size()));
    const double number = numbers.front();
    if (!(number >= 0 && number < 2147483648.0 && number == std::floor(number)))
      fail(fmt::format("material {} is no place in a list", number));
    return static_cast<int>(number);
  }

  void add_face(const std::vector<double>& corners, int material) {
    for (const double corner : corners)
      if (!(corner >= 0 && corner < 4294967296.0 && corner == std::floor(corner)))
        fail(fmt::format("vertex index {} is out of range or no whole number", corner));
    if (corners.size() < 3) fail("a face needs at least three corners");
    for (std::size_t i = 2; i < corners.size(); ++i) {
      out_.mesh.triangles.push_back({static_cast<std::uint32_t>(corners[0]),
                                     static_cast<std::uint32_t>(corners[i - 1]),
                                     static_cast<std::uint32_t>(corners[i])});
      out_.mesh.triangle_materials.push_back(material);
    }
  }

  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError(fmt::format("{}: {}", name_, problem));
  }

  std::string name_;
  std::string_view text_;
  std::size_t at_ = 0;
  FileNormals normals_;
  Encoding encoding_ = Encoding::Ascii;
  bool has_format_ = false;
  std::vector<Element> elements_;
  Row row_;
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
  out += fmt::format("element face {}\nproperty list uchar uint vertex_indices\n{}end_header\n",
                     mesh.triangles.size(), everything ? "property int material\n" : "");
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    append(out, mesh.positions[i]);
    append(out, mesh.normals[i]);
    if (everything) append(out, mesh.tangents[i]);
    append(out, mesh.uvs[i].x);
    append(out, mesh.uvs[i].y);
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    append(out, std::uint8_t{3});
    for (const std::uint32_t corner : mesh.triangles[i]) append(out, corner);
    if (everything) append(out, std::int32_t{mesh.triangle_materials[i]});
  }
  write_file(file, out);
}

}  // namespace orbs::scene

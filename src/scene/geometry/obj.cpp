#include "scene/geometry/obj.h"

#include "base/error.h"
#include "base/files.h"
#include "base/nth.h"
#include "base/text.h"
#include "scene/text_lines.h"

#include <array>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::scene {

namespace {

// "Advanced Visualizer Manual", Appendix B, Object Files (.obj). What changes nothing here: names, groups and
// smoothing (normals are given), files of materials (the scene has its own), points and lines, which have no
// area, the parameters of curves that no face uses, and how other programs are to draw what is there. "vw" is
// what some programs write as weights of their bones.
const std::set<std::string> kHarmless{"bevel",      "c_interp",  "d_interp", "g",  "l", "lod",
                                      "maplib",     "mg",        "mtllib",   "o",  "p", "s",
                                      "shadow_obj", "trace_obj", "usemap",   "vp", "vw"};

// Those that are read as text to the end of the line, which may end as a folder of Windows does.
const std::set<std::string> kTexts{"maplib", "mtllib", "o", "usemap", "usemtl"};

class ObjReader {
 public:
  ObjReader(const std::string& name, FileNormals normals) : name_(name), normals_rule_(normals) {}

  MeshFile read(std::string_view text) {
    take_byte_order_mark(text);
    while (!text.empty()) read_statement(text);
    if (faces_.empty()) fail("there is no face in the file");
    Polygons polygons;
    for (const Face& face : faces_) {
      line_ = face.line;
      for (std::size_t i = 0; i < face.size; ++i)
        polygons.corners.push_back(vertex(corners_[face.first_corner + i]));
      polygons.sizes.push_back(face.size);
      polygons.materials.push_back(face.material);
    }
    place_vertices(places_, out_);
    add_triangles(
        polygons, [this](std::size_t i) { return fmt::format("{}:{}", name_, faces_[i].line); }, out_);
    return std::move(out_);
  }

 private:
  using Corner = std::array<int, 3>;  // position, uv, normal; -1 where absent

  struct Face {
    int line;
    int material;
    std::size_t first_corner;
    std::uint32_t size;
  };

  // A comment begins with its line. In those of numbers it may also stand behind them, and a backslash at the
  // end goes on in the next line.
  void read_statement(std::string_view& text) {
    line_ = ++lines_;
    std::string line(trim(take_line(text)));
    if (line.empty() || line.front() == '#') return;
    const auto kind = line.substr(0, line.find_first_of(" \t"));
    if (kTexts.contains(kind)) {
      if (kind == "usemtl") use_material(std::string(trim(line.substr(kind.size()))));
      return;
    }
    line.resize(std::min(line.find('#'), line.size()));
    while (line.ends_with('\\')) {
      line.back() = ' ';
      if (text.empty()) break;
      line += trim(take_line(text));
      line.resize(std::min(line.find('#'), line.size()));
      ++lines_;
    }
    auto words = words_of(line);
    if (words.empty()) return;  // a backslash stood there alone
    const std::string statement = words.front();
    words.erase(words.begin());
    read_words(statement, words);
  }

  void read_words(const std::string& kind, const std::vector<std::string>& words) {
    if (kind == "v") {
      add_position(words);
    } else if (kind == "vn") {
      normals_.push_back(vec3<float>(words));
    } else if (kind == "vt") {
      if (words.empty()) fail("expected one to three numbers");
      uvs_.push_back({number<float>(words[0]), words.size() > 1 ? number<float>(words[1]) : 0});
    } else if (kind == "f" || kind == "fo") {  // fo is what f was called once
      add_face(words);
    } else if (!kHarmless.contains(kind)) {
      fail(fmt::format("'{}' is not read here; expected v, vn, vt, f, usemtl or one of {}", kind,
                       fmt::join(kHarmless, ", ")));
    }
  }

  template <typename Real>
  Real number(const std::string& word) const {
    const auto value = to_number(word);
    if (!value) fail(fmt::format("'{}' is not a number", word));
    return static_cast<Real>(*value);
  }

  template <typename Real>
  Vec3<Real> vec3(const std::vector<std::string>& words) const {
    if (words.size() < 3) fail(fmt::format("expected three numbers, found {}", words.size()));
    return {number<Real>(words[0]), number<Real>(words[1]), number<Real>(words[2])};
  }

  // A fourth number is the weight of a point of rational curves and surfaces; three more are its colour,
  // which programs have added and no material shows.
  void add_position(const std::vector<std::string>& words) {
    positions_.push_back(vec3<double>(words));
    if (words.size() == 4 && number<double>(words[3]) != 1)
      fail(fmt::format("the weight w is {}; only 1 is read, because a weight has no meaning in a face",
                       words[3]));
  }

  void use_material(const std::string& name) {
    material_ = -1;  // without a name: none
    if (name.empty()) return;
    const auto [entry, is_new] = materials_.emplace(name, static_cast<int>(out_.material_names.size()));
    if (is_new) {
      out_.material_names.push_back(name);
      out_.material_lines.push_back(line_);
    }
    material_ = entry->second;
  }

  // OBJ counts from 1; negative numbers count backwards from the last element so far. Others may lead to an
  // element that comes later, so they are held against the count at the end.
  int index(const std::string& word, std::size_t count, const char* what) const {
    const auto given = to_integer(word);
    if (!given) fail(fmt::format("'{}' is not an index", word));
    const long long at = *given < 0 ? static_cast<long long>(count) + *given : *given - 1;
    if (*given == 0 || at < 0 || at >= std::numeric_limits<int>::max())
      fail(fmt::format("{} index {} is out of range: there are {} so far", what, *given, count));
    return static_cast<int>(at);
  }

  void check_index(int at, std::size_t count, const char* what) const {
    if (at >= 0 && static_cast<std::size_t>(at) >= count)
      fail(fmt::format("{} index {} is out of range: there are {}", what, at + 1, count));
  }

  Corner corner(const std::string& word) {
    const auto parts = split(word, '/');
    const bool is_bare = parts.size() < 3 || parts[2].empty();
    if (is_bare && normals_rule_ == FileNormals::Required)
      fail("each corner needs a normal (v//vn or v/vt/vn); \"crease_angle\" in the scene has them computed");
    Corner result{index(parts[0], positions_.size(), "position"), -1,
                  is_bare ? -1 : index(parts[2], normals_.size(), "normal")};
    if (parts.size() > 1 && !parts[1].empty()) result[1] = index(parts[1], uvs_.size(), "texture coordinate");
    return result;
  }

  void add_face(const std::vector<std::string>& words) {
    if (words.size() < 3) fail(fmt::format("a face needs at least three corners, has {}", words.size()));
    faces_.push_back({line_, material_, corners_.size(), static_cast<std::uint32_t>(words.size())});
    for (const auto& word : words) corners_.push_back(corner(word));
  }

  Vec3f normal_of(const Corner& c) const {
    if (c[2] < 0) return {};
    const Vec3f normal = nth(normals_, c[2]);
    if (normals_rule_ == FileNormals::Required && !is_direction(normal))
      fail(
          fmt::format("normal {} is ({}, {}, {}), must be finite and not zero; \"crease_angle\" in the scene "
                      "has normals computed",
                      c[2] + 1, normal.x, normal.y, normal.z));
    return normal;
  }

  std::uint32_t vertex(const Corner& c) {
    Mesh& mesh = out_.mesh;
    const auto [entry, is_new] = vertices_.emplace(c, static_cast<std::uint32_t>(places_.size()));
    if (is_new) {
      check_index(c[0], positions_.size(), "position");
      check_index(c[1], uvs_.size(), "texture coordinate");
      check_index(c[2], normals_.size(), "normal");
      places_.push_back(nth(positions_, c[0]));
      mesh.uvs.push_back(c[1] < 0 ? Vec2f{} : nth(uvs_, c[1]));
      mesh.normals.push_back(normal_of(c));
      mesh.tangents.push_back({});
    }
    return entry->second;
  }

  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError(fmt::format("{}:{}: {}", name_, line_, problem));
  }

  std::string name_;
  FileNormals normals_rule_;
  int lines_ = 0;  // read so far
  int line_ = 0;   // where the statement begins
  int material_ = -1;
  std::vector<Vec3d> positions_;
  std::vector<Vec3f> normals_;
  std::vector<Vec2f> uvs_;
  std::vector<Corner> corners_;  // of the faces
  std::vector<Face> faces_;
  std::map<Corner, std::uint32_t> vertices_;
  std::vector<Vec3d> places_;             // of the vertices
  std::map<std::string, int> materials_;  // place in material_names
  MeshFile out_;
};

}  // namespace

MeshFile parse_obj(const std::string& name, std::string_view text, FileNormals normals) {
  return ObjReader(name, normals).read(text);
}

MeshFile read_obj(const std::filesystem::path& file, FileNormals normals) {
  return parse_obj(file.string(), read_file(file), normals);
}

}  // namespace orbs::scene

#include "scene/geometry/mesh_file.h"

#include "base/error.h"
#include "base/files.h"
#include "base/nth.h"
#include "base/text.h"
#include "scene/geometry/world_bounds.h"

#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::scene {

void place_vertices(const std::vector<Vec3d>& vertices, MeshFile& file) {
  auto placed = placed_vertices(vertices);
  file.mesh.positions = std::move(placed.positions);
  file.origin_m = placed.origin_m;
}

namespace {

// Statements that change nothing here: names, smoothing (normals are given), and the material file (the scene
// has its own materials).
const std::set<std::string> kHarmless{"g", "mtllib", "o", "s"};

class ObjReader {
 public:
  ObjReader(const std::string& name, FileNormals normals) : name_(name), normals_rule_(normals) {}

  MeshFile read(std::string_view text) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
    for (const auto& line : split(text, '\n')) {
      ++line_;
      read_line(std::string_view(line).substr(0, line.find('#')));
    }
    if (out_.mesh.triangles.empty()) fail("there is no face in the file");
    out_.lacks_normals = has_bare_corner_;
    place_vertices(places_, out_);
    return std::move(out_);
  }

 private:
  using Corner = std::array<int, 3>;  // position, uv, normal; -1 where absent

  void read_line(std::string_view line) {
    auto words = words_of(line);
    if (words.empty()) return;
    const std::string kind = words.front();
    words.erase(words.begin());
    if (kind == "v") {
      positions_.push_back(vec3<double>(words));
    } else if (kind == "vn") {
      normals_.push_back(vec3<float>(words));
    } else if (kind == "vt") {
      uvs_.push_back(vec2(words));
    } else if (kind == "usemtl") {
      use_material(words);
    } else if (kind == "f") {
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
    if (words.size() < 3) fail("expected three numbers");
    return {number<Real>(words[0]), number<Real>(words[1]), number<Real>(words[2])};
  }

  Vec2f vec2(const std::vector<std::string>& words) const {
    if (words.size() < 2) fail("expected two numbers");
    return {number<float>(words[0]), number<float>(words[1])};
  }

  void use_material(const std::vector<std::string>& words) {
    if (words.empty()) fail("usemtl needs a name");
    auto& names = out_.material_names;
    const auto [entry, is_new] = materials_.emplace(words.front(), static_cast<int>(names.size()));
    if (is_new) names.push_back(words.front());
    material_ = entry->second;
  }

  // OBJ counts from 1; negative numbers count backwards from the last element.
  int index(const std::string& word, std::size_t count, const char* what) const {
    const auto given = to_integer(word);
    if (!given) fail(fmt::format("'{}' is not an index", word));
    const long long at = *given < 0 ? static_cast<long long>(count) + *given : *given - 1;
    if (at < 0 || at >= static_cast<long long>(count))
      fail(fmt::format("{} index {} is out of range: there are {} so far", what, *given, count));
    return static_cast<int>(at);
  }

  Corner corner(const std::string& word) {
    const auto parts = split(word, '/');
    const bool is_bare = parts.size() < 3 || parts[2].empty();
    if (is_bare && normals_rule_ == FileNormals::Required)
      fail("each corner needs a normal (v//vn or v/vt/vn); \"crease_angle\" in the scene has them computed");
    if (places_.empty()) has_bare_corner_ = is_bare;
    if (is_bare != has_bare_corner_) fail("some corners have a normal and others have none");
    Corner result{index(parts[0], positions_.size(), "position"), -1,
                  is_bare ? -1 : index(parts[2], normals_.size(), "normal")};
    if (parts.size() > 1 && !parts[1].empty()) result[1] = index(parts[1], uvs_.size(), "texture coordinate");
    return result;
  }

  std::uint32_t vertex(const Corner& c) {
    Mesh& mesh = out_.mesh;
    const auto [entry, is_new] = vertices_.emplace(c, static_cast<std::uint32_t>(places_.size()));
    if (is_new) {
      places_.push_back(nth(positions_, c[0]));
      mesh.uvs.push_back(c[1] < 0 ? Vec2f{} : nth(uvs_, c[1]));
      mesh.normals.push_back(c[2] < 0 ? Vec3f{} : nth(normals_, c[2]));
      mesh.tangents.push_back({});
    }
    return entry->second;
  }

  void add_face(const std::vector<std::string>& words) {
    if (words.size() < 3) fail("a face needs at least three corners");
    std::vector<std::uint32_t> corners;
    for (const auto& word : words) corners.push_back(vertex(corner(word)));
    for (std::size_t i = 2; i < corners.size(); ++i) {
      out_.mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
      out_.mesh.triangle_materials.push_back(material_);
    }
  }

  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError(fmt::format("{}:{}: {}", name_, line_, problem));
  }

  std::string name_;
  FileNormals normals_rule_;
  bool has_bare_corner_ = false;  // the first corner has no normal
  int line_ = 0;
  int material_ = -1;
  std::vector<Vec3d> positions_;
  std::vector<Vec3f> normals_;
  std::vector<Vec2f> uvs_;
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

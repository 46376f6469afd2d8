#include "scene/load/entry.h"

#include "base/files.h"
#include "base/text.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::scene {

void Names::add(json::ObjectReader& in, const std::string& key) {
  const std::string name = in.system_text(key);
  if (name.empty()) in.fail(key, "must not be empty");
  if (!index_.emplace(name, static_cast<int>(index_.size())).second)
    in.fail(key, fmt::format("{} '{}' is defined twice", kind_, name));
}

int Names::lookup(const std::string& name) const {
  const auto found = index_.find(name);
  return found == index_.end() ? -1 : found->second;
}

std::string Names::unknown(const std::string& name) const {
  std::set<std::string> known;
  for (const auto& entry : index_) known.insert(entry.first);
  return fmt::format("there is no {} '{}'{}", kind_, name, closest(name, known));
}

int Names::find(json::ObjectReader& in, const std::string& key) const {
  const std::string name = in.text(key);
  const int index = lookup(name);
  if (index < 0) in.fail(key, unknown(name));
  return index;
}

int Names::find_at(const json::ObjectReader& in,
                   const std::string& key,
                   std::size_t index,
                   const std::string& name) const {
  const int found = lookup(name);
  if (found < 0) in.fail_at(key, index, unknown(name));
  return found;
}

namespace {

bool lies_in(const std::filesystem::path& file, const std::filesystem::path& folder) {
  const auto canonical = std::filesystem::weakly_canonical(folder);
  const auto [end, _] = std::mismatch(canonical.begin(), canonical.end(), file.begin(), file.end());
  return end == canonical.end();
}

std::vector<std::string> folder_names(const std::vector<std::filesystem::path>& folders) {
  std::vector<std::string> names;
  for (const auto& folder : folders) names.push_back(folder.string());
  return names;
}

}  // namespace

std::filesystem::path existing_file(json::ObjectReader& in,
                                    const std::string& key,
                                    const DataFolders& folders) {
  const auto path = resolve_path(folders.own, in.system_text(key));
  std::error_code failed;
  auto meant = std::filesystem::weakly_canonical(path, failed);
  if (failed) meant = path;  // links in a circle, which are no file
  auto allowed = folders.allowed;
  if (!allowed.empty()) allowed.push_back(folders.own);
  if (!allowed.empty() && std::none_of(allowed.begin(), allowed.end(),
                                       [&](const auto& folder) { return lies_in(meant, folder); }))
    in.fail(key, fmt::format("leads to {}, outside of the folders in which files of a scene may lie: {}; add "
                             "its folder to \"data\" of the suite in configuration.json",
                             meant.string(), fmt::join(folder_names(allowed), ", ")));
  if (const auto problem = no_file_problem(path); !problem.empty()) in.fail(key, problem);
  return path;
}

void spend(const json::ObjectReader& in,
           const std::string& key,
           const char* objects,
           std::size_t wanted,
           std::size_t& left) {
  if (wanted > left)
    in.fail(key, fmt::format("asks for {} {}; the scene may hold {} more", wanted, objects, left));
  left -= wanted;
}

namespace {

Mat4 load_step(json::ObjectReader& step) {
  const auto keys = step.keys();
  if (keys.size() != 1)
    step.fail("", "a step holds exactly one of: translate, rotate_x, rotate_y, rotate_z, scale");
  const std::string& kind = keys.front();
  if (kind == "translate") return translation(step.vec3(kind));
  if (kind == "rotate_x") return rotation_x(step.number(kind));
  if (kind == "rotate_y") return rotation_y(step.number(kind));
  if (kind == "rotate_z") return rotation_z(step.number(kind));
  if (kind == "scale" && step.holds_array(kind)) return scaling(step.vec3(kind));
  if (kind == "scale") {
    const double factor = step.number(kind);
    return scaling({factor, factor, factor});
  }
  step.fail(kind, "unknown step" + closest(kind, {"translate", "rotate_x", "rotate_y", "rotate_z", "scale"}));
}

}  // namespace

Mat4 load_matrix(json::ObjectReader& in, const std::string& key) {
  Mat4 matrix;
  if (!in.has(key)) return matrix;
  if (in.holds_objects(key)) {
    for (auto& step : in.objects(key)) matrix = matrix * load_step(step);
  } else {
    const auto numbers = in.numbers(key, 16);
    std::copy(numbers.begin(), numbers.end(), matrix.m.begin());
  }
  if (const auto problem = matrix_problem(matrix); !problem.empty()) in.fail(key, problem);
  return matrix;
}

void refuse_motion(json::ObjectReader& in, const char* objects) {
  if (in.has("end_matrix"))
    in.fail(
        "end_matrix",
        fmt::format("{} cannot move within a frame, only instances of meshes can: leave it out", objects));
}

std::string matrix_problem(const Mat4& matrix) {
  for (const double entry : matrix.m)
    if (!(std::abs(entry) <= kFarthest_m))
      return fmt::format("the matrix holds {}; entries must lie in [{}, {}]", entry, -kFarthest_m,
                         kFarthest_m);
  if (!is_affine(matrix)) return "the last row must be 0 0 0 1 (row-major 4x4)";
  if (!inverse(matrix)) return "the matrix is not invertible: its 3x3 part is singular";
  return "";
}

}  // namespace orbs::scene

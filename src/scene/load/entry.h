#pragma once

#include "base/matrix.h"
#include "json/object_reader.h"

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

/// What the entries of a scene file have in common: names, files, matrices, and the bounds of numbers. All
/// functions throw InputError at the key that is wrong.
namespace orbs::scene {

/// Places and lengths in metres, and the entries of matrices. Renderers compute in floats, and beyond these
/// the product of three lengths is nothing that a float holds (3.4e38, 1.2e-38).
constexpr double kFarthest_m = 1e12;
constexpr json::Range kPlace{-kFarthest_m, kFarthest_m};
constexpr json::Range kLength{1e-12, kFarthest_m};

/// Names of one kind of object, in file order: name -> index, with complaints about names that are given
/// twice and names that nothing has.
class Names {
 public:
  explicit Names(std::string kind) : kind_(std::move(kind)) {}
  void add(json::ObjectReader& in, const std::string& key);
  /// Index of the name that the text under `key` holds.
  int find(json::ObjectReader& in, const std::string& key) const;
  /// Index of `name`, which stands at element `index` of the array under `key`.
  int find_at(const json::ObjectReader& in,
              const std::string& key,
              std::size_t index,
              const std::string& name) const;
  /// Index of `name`, -1 when there is none.
  int lookup(const std::string& name) const;
  /// The complaint about a name that nothing has, with the nearest one that something has.
  std::string unknown(const std::string& name) const;

 private:
  std::string kind_;
  std::map<std::string, int> index_;
};

/// What one scene may hold: more is a mistake, or meant to exhaust the machine. Some 4 GB.
struct SceneBudget {
  std::size_t triangles = std::size_t{1} << 26;  // stored once for each mesh
  std::size_t instances = std::size_t{1} << 22;
};

/// Subtracts `wanted` from what is `left` of a budget; the complaint, at `key`, says how many `objects`
/// ("triangles") the scene may still hold.
void spend(const json::ObjectReader& in,
           const std::string& key,
           const char* objects,
           std::size_t wanted,
           std::size_t& left);

/// Where the files that a scene names may lie.
struct DataFolders {
  std::filesystem::path own;  // of the scene; relative paths start here
  /// Scenes come from strangers: files must lie in these folders or in `own`, wherever `..` and symbolic
  /// links lead. Empty: anywhere.
  std::vector<std::filesystem::path> allowed{};
};

/// The file under `key`; it must exist, be a regular file and lie in one of the folders.
std::filesystem::path existing_file(json::ObjectReader& in,
                                    const std::string& key,
                                    const DataFolders& folders);

/// "matrix": 16 numbers row-major, or steps {"translate"|"rotate_x"|"rotate_y"|"rotate_z"|"scale": ...}
/// multiplied in written order. Identity when absent. Must be affine and invertible.
Mat4 load_matrix(json::ObjectReader& in, const std::string& key);

/// Refuses the key "end_matrix" of `objects` ("lights"), which cannot move.
void refuse_motion(json::ObjectReader& in, const char* objects);

/// The complaint about a matrix that is not affine or not invertible; "" when it is both.
std::string matrix_problem(const Mat4& matrix);

}  // namespace orbs::scene

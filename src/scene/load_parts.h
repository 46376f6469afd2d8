#pragma once

#include "json/object_reader.h"
#include "scene/load_scene.h"
#include "scene/scene.h"

#include <filesystem>
#include <map>
#include <string>

/// The pieces of load_scene, one per kind of thing in the file. All throw InputError at the key that is
/// wrong.
namespace orbs::scene {

/// Places and lengths in metres, and the entries of matrices. Renderers compute in floats, and beyond these
/// the product of three lengths is nothing that a float holds (3.4e38, 1.2e-38).
constexpr double kFarthest_m = 1e12;
constexpr json::Range kPlace{-kFarthest_m, kFarthest_m};
constexpr json::Range kLength{1e-12, kFarthest_m};

/// Names given to one kind of thing, in file order: name -> index, with complaints about doubles and dangling
/// names.
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
  /// Index of `name`, -1 when there is none; `hint` for the complaint.
  int lookup(const std::string& name) const;
  std::string unknown(const std::string& name) const;

 private:
  std::string kind_;
  std::map<std::string, int> index_;
};

/// The file under `key`, resolved against `folder`; it must exist and be a regular file.
std::filesystem::path existing_file(json::ObjectReader& in,
                                    const std::string& key,
                                    const std::filesystem::path& folder);

/// "matrix": 16 numbers row-major, or steps {"translate"|"rotate_x"|"rotate_y"|"rotate_z"|"scale": ...}
/// multiplied in written order. Identity when absent. Must be affine and invertible.
Mat4 load_matrix(json::ObjectReader& in, const std::string& key);

/// The complaint about a matrix that cannot move things there and back; "" when it can.
std::string matrix_problem(const Mat4& matrix);

Material load_material(json::ObjectReader in, const Names& textures);
/// Takes `wanted` things off what is `left`; the complaint at `key` when there are not so many.
void take(const json::ObjectReader& in,
          const std::string& key,
          const char* things,
          std::size_t wanted,
          std::size_t& left);
Mesh load_mesh(json::ObjectReader in,
               const std::filesystem::path& folder,
               const Names& materials,
               SceneBudget& left);
/// The mesh of the entry's "generator", without name and materials.
Mesh load_generated(json::ObjectReader& in, SceneBudget& left);
/// Appends one instance to the scene, or many when the entry has "scatter".
void load_instances(json::ObjectReader in,
                    const Names& meshes,
                    const Names& materials,
                    SceneBudget& left,
                    std::vector<Instance>& out);
Light load_light(json::ObjectReader in, const std::filesystem::path& folder);

}  // namespace orbs::scene

#include "scene/load/instance.h"

#include "base/random.h"
#include "scene/motion.h"

#include <fmt/format.h>

namespace orbs::scene {

namespace {

std::vector<std::pair<int, int>> load_remap(json::ObjectReader& in, const Names& materials) {
  std::vector<std::pair<int, int>> remap;
  if (!in.has("remap")) return remap;
  const auto names = in.texts("remap");
  if (names.size() % 2 != 0)
    in.fail("remap", fmt::format("must hold pairs (from, to), holds {} names: an odd number", names.size()));
  for (std::size_t i = 0; i < names.size(); i += 2) {
    const int from = materials.find_at(in, "remap", i, names[i]);
    const int to = materials.find_at(in, "remap", i + 1, names[i + 1]);
    for (const auto& pair : remap)
      if (pair.first == from)
        in.fail_at("remap", i, fmt::format("'{}' is replaced twice in one list", names[i]));
    remap.emplace_back(from, to);
  }
  return remap;
}

std::string problem_of(const Instance& instance) {
  if (auto problem = matrix_problem(instance.matrix); !problem.empty()) return problem;
  if (!instance.end_matrix) return "";
  if (auto problem = matrix_problem(*instance.end_matrix); !problem.empty()) return problem;
  return motion_problem(instance.matrix, *instance.end_matrix);
}

/// Copies on a grid in the XZ plane, centred on the instance's matrix: each is moved by up to +-jitter along
/// x and z, turned about y by any angle, and left out with probability 1 - keep. The numbers depend on seed
/// and grid place alone.
void scatter(json::ObjectReader in,
             const Instance& prototype,
             SceneBudget& left,
             std::vector<Instance>& out) {
  const int columns = in.integer("columns", 1, 1000);
  const int rows = in.integer("rows", 1, 1000);
  spend(in, "", "instances", static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows),
        left.instances);
  const double spacing_m = in.number("spacing", json::kPositive);
  const double jitter_m = in.number_or("jitter", 0, json::kNotNegative);
  const double keep = in.number_or("keep", 1, {0, 1});
  const double scale = in.number_or("scale", 1, json::kPositive);
  const auto seed = static_cast<std::uint64_t>(in.integer_or("seed", 1, 0, 1 << 30));
  in.finish();
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const auto cell = static_cast<std::uint64_t>(row) * 1000 + static_cast<std::uint64_t>(column);
      const auto random = [&](std::uint64_t purpose) { return unit_random(mix(mix(seed, cell), purpose)); };
      if (random(0) >= keep) continue;
      const Vec3d place{(column - 0.5 * (columns - 1)) * spacing_m + jitter_m * (2 * random(1) - 1), 0,
                        (row - 0.5 * (rows - 1)) * spacing_m + jitter_m * (2 * random(2) - 1)};
      Instance copy = prototype;
      copy.name = fmt::format("{} {} {}", prototype.name, row, column);
      const Mat4 on_grid = translation(place) * rotation_y(360 * random(3)) * scaling({scale, scale, scale});
      copy.matrix = prototype.matrix * on_grid;
      if (copy.end_matrix) copy.end_matrix = *prototype.end_matrix * on_grid;
      if (const auto problem = problem_of(copy); !problem.empty())
        in.fail("", fmt::format("copy {} {}: {}", row, column, problem));
      out.push_back(std::move(copy));
    }
}

}  // namespace

void load_instances(json::ObjectReader in,
                    const Names& meshes,
                    const Names& materials,
                    SceneBudget& left,
                    std::vector<Instance>& out) {
  Instance instance;
  instance.mesh = meshes.find(in, "mesh");
  instance.name = in.text_or("name", in.text("mesh"));
  instance.matrix = load_matrix(in, "matrix");
  if (in.has("end_matrix")) {
    instance.end_matrix = load_matrix(in, "end_matrix");
    if (const auto problem = motion_problem(instance.matrix, *instance.end_matrix); !problem.empty())
      in.fail("end_matrix", problem);
  }
  instance.remap = load_remap(in, materials);
  if (in.has("scatter")) {
    scatter(in.object("scatter"), instance, left, out);
  } else {
    spend(in, "", "instances", 1, left.instances);
    out.push_back(std::move(instance));
  }
  in.finish();
}

}  // namespace orbs::scene

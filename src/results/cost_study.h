#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// The folder of a cost study as the server and the one-file page see it. The page reads cost.json as it is;
/// these parts only say what lies in the folder.
namespace orbs::results {

inline constexpr const char* kCostFile = "cost.json";
inline constexpr const char* kCostFormat = "orbs-cost/1";

struct CostImages {
  std::vector<std::string> references;  // EXR, one per target
  std::vector<std::string> points;      // PNG, one per point: the last rung of each curve first
};

struct CostStudy {
  std::string started;
  CostImages images;  // relative to the folder, as the file names them
};

/// True if the folder holds a cost.json.
bool holds_cost_study(const std::filesystem::path& folder);

/// InputError if cost.json is missing, broken, or of another format than "orbs-cost/1".
CostStudy read_cost_study(const std::filesystem::path& folder);

}  // namespace orbs::results

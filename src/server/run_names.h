#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace orbs::server {

/// Names of the runs in these absolute folders, for the page and its links: the folder's name, preceded by as
/// many of its parents as make it unique ("monday/outputs", "tuesday/outputs").
std::vector<std::string> run_names(const std::vector<std::filesystem::path>& folders);

}  // namespace orbs::server

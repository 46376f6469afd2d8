#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace orbs::server {

/// What the page calls the runs in these absolute folders: the folder's name, with as many of the folders
/// above it as tell it from the others ("monday/outputs", "tuesday/outputs"). Links say it.
std::vector<std::string> run_names(const std::vector<std::filesystem::path>& folders);

}  // namespace orbs::server

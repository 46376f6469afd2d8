#include "cli/configuration_place.h"

#include "base/error.h"
#include "base/files.h"
#include "registry/configuration.h"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>

namespace orbs::cli {

namespace {

namespace fs = std::filesystem;

constexpr const char* kName = "configuration.json";

// "" for a variable that is not set; the XDG base directory specification has relative paths ignored.
fs::path folder_of_variable(const char* name) {
  const char* text = std::getenv(name);
  return text != nullptr && fs::path(text).is_absolute() ? fs::path(text) : fs::path();
}

fs::path system_file() {
  const auto folder = folder_of_variable("ORBS_SYSTEM_FOLDER");
  return (folder.empty() ? fs::path("/etc/orbs") : folder) / kName;
}

fs::path user_file() {
  if (const auto folder = folder_of_variable("XDG_CONFIG_HOME"); !folder.empty())
    return folder / "orbs" / kName;
  const auto home = folder_of_variable("HOME");
  return home.empty() ? fs::path() : home / ".config/orbs" / kName;
}

bool is_file(const fs::path& file) {
  std::error_code ignored;
  return fs::is_regular_file(file, ignored);
}

bool are_same(const fs::path& a, const fs::path& b) {
  std::error_code ignored;
  return fs::equivalent(a, b, ignored);
}

// In a checkout the programs lie in a folder of the build, and the file is the user's to edit.
bool is_of_installation(const fs::path& file, const Program& program) {
  return are_same(fs::absolute(file).parent_path(), program.folder);
}

fs::path own_file(const fs::path& uppermost, const Program& program) {
  const bool is_of_all =
      uppermost.empty() || is_of_installation(uppermost, program) || are_same(uppermost, system_file());
  return is_of_all ? user_file() : fs::absolute(uppermost).lexically_normal();
}

}  // namespace

ConfigurationPlace configuration_place(const std::string& named, const Program& program) {
  fs::path uppermost = named;
  if (named.empty()) uppermost = registry::nearest_configuration(fs::current_path()).value_or("");
  ConfigurationPlace place;
  auto& layers = place.files.layers;
  const auto shipped = registry::nearest_configuration(program.folder);
  if (shipped) {
    place.files.data = shipped->parent_path() / "data";
    // By the name that the user gave it, which messages have.
    layers.push_back(!uppermost.empty() && are_same(uppermost, *shipped) ? uppermost : *shipped);
  }
  for (const auto& file : {system_file(), user_file()})
    if (is_file(file) && !are_same(file, uppermost)) layers.push_back(file);
  const bool is_there = !layers.empty() && layers.front() == uppermost;
  if (!uppermost.empty() && !is_there) layers.push_back(uppermost);
  if (layers.empty())
    throw InputError(fmt::format("there is no {} in {} or above; name one with --configuration", kName,
                                 fs::current_path().string()));
  place.own = own_file(uppermost, program);
  return place;
}

}  // namespace orbs::cli

#include "cli/options.h"

#include "base/error.h"
#include "cli/checks.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::cli {

std::shared_ptr<std::string> add_configuration_option(CLI::App& command) {
  auto file = std::make_shared<std::string>();
  command
      .add_option("--configuration", *file,
                  "File with suites, renderers and defaults (default: the nearest configuration.json)")
      ->check(not_empty("a file"));
  return file;
}

registry::Configuration read_configuration(const std::string& named, const Program& program) {
  if (!named.empty()) return registry::load_configuration(named);
  for (const auto& from : {std::filesystem::current_path(), program.folder})
    if (const auto file = registry::nearest_configuration(from)) return registry::load_configuration(*file);
  throw InputError(fmt::format("there is no configuration.json in {} or above; name one with --configuration",
                               std::filesystem::current_path().string()));
}

std::string joined_list(const std::vector<std::string>& values) {
  return fmt::format("{}", fmt::join(values, ","));
}

}  // namespace orbs::cli

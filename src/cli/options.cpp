#include "cli/options.h"

#include "adapters/export.h"
#include "base/error.h"
#include "registry/image_size.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::cli {

namespace {

// The exporters know the words of "scene_format", the registry does not.
registry::Configuration checked_configuration(const std::filesystem::path& file) {
  auto configuration = registry::load_configuration(file);
  for (const auto& renderer : configuration.renderers) adapters::check_scene_format(renderer);
  return configuration;
}

}  // namespace

std::shared_ptr<std::string> add_configuration_option(const command_line::Command& command) {
  auto file = std::make_shared<std::string>();
  command
      .add_option("--configuration", *file,
                  "File with suites, renderers and defaults (default: the nearest configuration.json)")
      .not_empty("a file");
  return file;
}

registry::Configuration read_configuration(const std::string& named, const Program& program) {
  if (!named.empty()) return checked_configuration(named);
  for (const auto& from : {std::filesystem::current_path(), program.folder})
    if (const auto file = registry::nearest_configuration(from)) return checked_configuration(*file);
  throw InputError(fmt::format("there is no configuration.json in {} or above; name one with --configuration",
                               std::filesystem::current_path().string()));
}

void add_filter_options(const command_line::Command& command, TargetFilters& filters) {
  command.add_option("--suite", filters.suite, "The suite (default: that of the configuration)");
  command.add_option("-c,--case", filters.cases, "Only these cases");
  command.add_option("-s,--scene", filters.scenes, "Only these scenes");
}

void add_size_option(const command_line::Command& command, std::string& size) {
  std::vector<std::string> sizes;
  for (const int divisor : registry::kSizeDivisors) sizes.push_back(registry::size_text(divisor));
  command.add_option("--size", size, "Width and height of all images, as a share of the scenes' (default: 1)")
      .one_of(sizes);
}

registry::RunSettings filtered_settings(const registry::Configuration& configuration,
                                        const TargetFilters& filters) {
  auto settings = configuration.defaults;
  if (!filters.suite.empty()) settings.suite = filters.suite;
  if (!filters.cases.empty()) settings.cases = joined_list(filters.cases);
  if (!filters.scenes.empty()) settings.scenes = joined_list(filters.scenes);
  return settings;
}

std::string joined_list(const std::vector<std::string>& values) {
  return fmt::format("{}", fmt::join(values, ","));
}

}  // namespace orbs::cli

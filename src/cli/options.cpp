#include "cli/options.h"

#include "adapters/export.h"
#include "adapters/process/isolation.h"
#include "base/error.h"
#include "base/files.h"
#include "base/terminal.h"
#include "cli/interrupt.h"

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

void take_configuration(const std::string& configuration, run::FiledPlan& plan) {
  if (configuration.empty()) return;
  if (const auto problem = no_file_problem(configuration); !problem.empty()) throw InputError(problem);
  const auto file = std::filesystem::absolute(configuration).lexically_normal();
  plan.root = file.parent_path().string();
  plan.configuration = file.filename().string();
}

void refuse_without_sandbox(bool sandbox) {
  if (!sandbox) return;
  if (const auto reason = adapters::why_not_isolated(); !reason.empty()) throw InputError(reason);
}

std::string joined_list(const std::vector<std::string>& values) {
  return fmt::format("{}", fmt::join(values, ","));
}

studies::StudyContext study_context(const Program& program, std::FILE* stream) {
  return {program.folder, program.version, &catch_interrupts(), [=](const std::string& line) {
            print_clean(stream, "{}\n", line);
            // Without this a file or a pipe would get its first line after minutes.
            std::fflush(stream);
          }};
}

}  // namespace orbs::cli

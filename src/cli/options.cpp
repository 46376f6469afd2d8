#include "cli/options.h"

#include "adapters/export.h"
#include "adapters/process/isolation.h"
#include "base/error.h"
#include "base/files.h"
#include "base/terminal.h"
#include "cli/configuration_place.h"
#include "cli/interrupt.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::cli {

std::shared_ptr<std::string> add_configuration_option(const command_line::Command& command) {
  auto file = std::make_shared<std::string>();
  command
      .add_option("--configuration", *file,
                  "File with suites, renderers and defaults, over the shipped one and that of the user "
                  "(default: the nearest configuration.json)")
      .not_empty("a file");
  return file;
}

registry::Configuration read_configuration(const std::string& named, const Program& program) {
  const auto place = configuration_place(named, program);
  auto configuration = registry::load_configuration(place.files);
  configuration.own_file = place.own;
  // The exporters know the words of "scene_format", the registry does not.
  for (const auto& renderer : configuration.renderers) adapters::check_scene_format(renderer);
  return configuration;
}

void take_configuration(const std::string& named, const Program& program, run::FiledPlan& plan) {
  if (named.empty()) return;
  if (const auto problem = no_file_problem(named); !problem.empty()) throw InputError(problem);
  const auto configuration = read_configuration(named, program);
  plan.root = configuration.root.string();
  plan.configuration = configuration.file.string();
}

void refuse_size_in_pixels(const command_line::Command& command) {
  command.refuse_option(
      "--size",
      "is a share of the scenes' size, which this command does not use; its images are given in "
      "pixels: --side 64");
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

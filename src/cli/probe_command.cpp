#include "base/error.h"
#include "base/files.h"
#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/not_empty.h"
#include "runner/make_plan.h"
#include "studies/probe.h"

#include <algorithm>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace orbs::cli {

namespace {

struct ProbeOptions {
  std::string suite;
  std::vector<std::string> cases, scenes, renderers;
  std::string executable;
  std::string output;
  studies::ProbeSettings probe;
};

void add_options(CLI::App& command, ProbeOptions& options) {
  constexpr int kMostThreads = 1024;
  command.add_option("--suite", options.suite, "the suite");
  command.add_option("-c,--case", options.cases, "only the scenes of these cases");
  command.add_option("-s,--scene", options.scenes, "only these scenes");
  command.add_option("-r,--renderer", options.renderers,
                     "only these renderers (default: all that are installed)");
  command.add_option("-e,--exec", options.executable,
                     "program to start instead of the chosen renderer's own");
  command.add_option("--size", options.probe.most_px, "longer side of the images in pixels")
      ->check(CLI::Range(16, 1024))
      ->capture_default_str();
  command.add_option("--spp", options.probe.spp, "samples per pixel")
      ->check(CLI::Range(1, 4096))
      ->capture_default_str();
  command.add_option("--threads", options.probe.threads, "threads of each render")
      ->check(CLI::Range(1, kMostThreads))
      ->capture_default_str();
  command.add_option("-o,--output", options.output, "JSON file for all findings")->check(not_empty("a file"));
}

int probe(const registry::Configuration& configuration, const ProbeOptions& options, const Program& program) {
  if (!options.output.empty()) check_output_file(options.output);
  auto settings = configuration.defaults;
  if (!options.suite.empty()) settings.suite = options.suite;
  if (!options.cases.empty()) settings.cases = joined_list(options.cases);
  if (!options.scenes.empty()) settings.scenes = joined_list(options.scenes);
  if (!options.renderers.empty()) settings.renderers = joined_list(options.renderers);
  settings.executable = options.executable;
  const auto plan = runner::make_plan(configuration, settings, program.folder);
  const auto& stop = catch_interrupts();
  const auto say = [](const std::string& line) {
    fmt::print("{}\n", line);
    std::fflush(stdout);
  };
  const auto records = studies::run_probe(plan, options.probe, {&stop, say});
  if (!options.output.empty()) write_file(options.output, studies::probe_json(records));
  if (stop) return kInterrupted;
  const auto wrong = std::count_if(records.begin(), records.end(),
                                   [](const auto& record) { return !studies::is_mapped_right(record); });
  say(wrong == 0 ? fmt::format("all {} are where they should be", records.size())
                 : fmt::format("{} of {} are not right", wrong, records.size()));
  return wrong == 0 ? 0 : 1;
}

}  // namespace

void add_probe_command(CLI::App& app, const Program& program, Action& action) {
  auto* command = app.add_subcommand(
      "probe", "Checks that each renderer sees camera, geometry and texture coordinates as each scene says");
  const auto configuration = add_configuration_option(*command);
  const auto options = std::make_shared<ProbeOptions>();
  add_options(*command, *options);
  command->footer(
      "Every material of every instance, and every light, emits a flat colour of its own; a second "
      "image\n"
      "shows texture coordinates. Both are compared with what the scene's numbers say must be in each "
      "pixel.");
  command->callback([=, &program, &action] {
    action = [=, &program] { return probe(read_configuration(*configuration, program), *options, program); };
  });
}

}  // namespace orbs::cli

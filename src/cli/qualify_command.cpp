#include "base/error.h"
#include "base/files.h"
#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/not_empty.h"
#include "cli/number_checks.h"
#include "results/run_folder.h"
#include "runner/make_plan.h"
#include "studies/qualify.h"

#include <algorithm>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace orbs::cli {

namespace {

struct QualifyOptions {
  std::string run;
  std::string suite;
  std::vector<std::string> cases, scenes;
  int threads = 0;
  std::string output;
  studies::QualifySettings qualify;
};

void add_options(CLI::App& command, QualifyOptions& options) {
  constexpr int kMostThreads = 1024;
  command.add_option("run", options.run,
                     "folder of a run with control images, of another seed than the references (default: "
                     "the newest outputs-*)");
  command.add_option("--suite", options.suite, "the suite");
  command.add_option("-c,--case", options.cases, "only the gates of these cases");
  command.add_option("-s,--scene", options.scenes, "only those of these scenes");
  command
      .add_option(
          "-r,--renderer", options.qualify.renderer,
          "whose images of the run are the control images; it also renders the scenes that lack a light")
      ->capture_default_str();
  command
      .add_option("--spp-scale", options.qualify.missing_light_spp_scale,
                  "multiplies the samples of the renders without one of the lights")
      ->check(above_zero())
      ->capture_default_str();
  command.add_option("--threads", options.threads, "0: all cores")->check(CLI::Range(0, kMostThreads));
  command
      .add_option("-o,--output", options.output,
                  "file for the results (default: qualification.json beside the references)")
      ->check(not_empty("a file"));
}

int qualify(const registry::Configuration& configuration,
            const QualifyOptions& options,
            const Program& program) {
  auto settings = configuration.defaults;
  if (!options.suite.empty()) settings.suite = options.suite;
  if (!options.cases.empty()) settings.cases = joined_list(options.cases);
  if (!options.scenes.empty()) settings.scenes = joined_list(options.scenes);
  settings.renderers = options.qualify.renderer;
  settings.threads = options.threads;
  settings.jobs = 1;
  const auto plan = runner::make_plan(configuration, settings, program.folder);
  const auto file = options.output.empty() ? plan.suite.references / results::kQualificationFile
                                           : std::filesystem::path(options.output);
  check_output_file(file);
  const auto folder = options.run.empty() ? newest_runs().front() : std::filesystem::path(options.run);
  const auto run = results::read_run_folder(folder).run;
  const auto& stop = catch_interrupts();
  const auto say = [](const std::string& line) { fmt::print(stderr, "{}\n", line); };
  const auto gates = studies::qualify(plan, run, options.qualify, {program.version, &stop, say});
  if (stop) return kInterrupted;
  write_file(file, results::qualification_json(studies::merged(results::read_qualification(file), gates)));
  fmt::print("{}{}\n", studies::qualification_text(gates), file.string());
  return std::all_of(gates.begin(), gates.end(), results::is_qualified) ? 0 : 1;
}

}  // namespace

void add_qualify_command(CLI::App& app, const Program& program, Action& action) {
  auto* command = app.add_subcommand(
      "qualify", "Proves that each gate can fail: gives control images every usual fault and judges them");
  const auto configuration = add_configuration_option(*command);
  const auto options = std::make_shared<QualifyOptions>();
  add_options(*command, *options);
  command->footer(
      "First: orbs run -r orbs. Exit status: 0 every gate accepts the control image and rejects every "
      "fault, 1 one does not.");
  command->callback([=, &program, &action] {
    action = [=, &program] {
      return qualify(read_configuration(*configuration, program), *options, program);
    };
  });
}

}  // namespace orbs::cli

#include "base/error.h"
#include "base/files.h"
#include "base/terminal.h"
#include "cli/options.h"
#include "cli/program.h"
#include "cli/run/run_options.h"
#include "cli/show_runs.h"
#include "registry/image_size.h"
#include "results/run_folder.h"
#include "run/plan/make_plan.h"
#include "studies/qualify/diagnosis_rates.h"
#include "studies/qualify/qualify.h"
#include "studies/qualify/reports.h"

#include <algorithm>

#include <fmt/format.h>

namespace orbs::cli {

namespace {

struct QualifyOptions {
  std::string folder;
  RunOptions run;
  int threads = 0;
  std::string output;
  bool diagnoses = false;
  studies::QualifySettings qualify;
};

void add_options(const command_line::Command& command, QualifyOptions& options) {
  constexpr int kMostThreads = 1024;
  command.add_option(
      "run", options.folder,
      "Folder of a run with the control images, whose seed differs from the references' (default: "
      "the newest outputs-*)");
  add_settings(command, options.run, {"suite", "case", "scene", "sandbox"});
  command
      .add_option(
          "-r,--renderer", options.qualify.renderer,
          "Renderer whose images in the run are the control images; it also renders the scenes without a light")
      .shows_default();
  command
      .add_option("--spp-scale", options.qualify.missing_light_spp_scale,
                  "Multiply the samples of the renders without a light")
      .above_zero()
      .shows_default();
  command.add_option("--threads", options.threads, "Threads; 0: all cores").range(0, kMostThreads);
  command
      .add_option(
          "-o,--output", options.output,
          "File for the results (default: beside the references, qualification.json or, for a run at 1/4, "
          "qualification-1-4.json)")
      .not_empty("a file");
  command.add_flag(
      "--diagnoses", options.diagnoses,
      "Tests no gates: counts how often the diagnosis of a typical fault is right, and writes no file");
}

int qualify(const command_line::Command& command,
            const registry::Configuration& configuration,
            const QualifyOptions& options,
            const Program& program) {
  auto settings = study_settings(command, options.run, configuration.defaults);
  settings.renderers = options.qualify.renderer;
  settings.threads = options.threads;
  settings.jobs = 1;
  if (!options.output.empty()) check_output_file(options.output);
  const auto folder = options.folder.empty() ? newest_runs().front() : std::filesystem::path(options.folder);
  const auto run = results::read_run_folder(folder).run;
  // The control images have the size of their run, and so must all that they are compared with.
  settings.size_divisor = registry::size_divisor(run.size);
  const auto plan = run::make_plan(configuration, settings, program.folder);
  const auto context = study_context(program, stderr);
  if (options.diagnoses) {
    print_clean("{}", studies::diagnoses_text(
                          studies::measure_diagnoses(plan, run, options.qualify.renderer, context)));
    return is_stopped(context) ? kInterrupted : 0;
  }
  const auto file = options.output.empty() ? plan.suite.references / results::qualification_file(run.size)
                                           : std::filesystem::path(options.output);
  if (options.output.empty()) check_output_file(file);
  const auto gates = studies::qualify(plan, run, options.qualify, context);
  if (is_stopped(context)) return kInterrupted;
  write_file(file, results::qualification_json(studies::merged(results::read_qualification(file), gates)));
  print_clean("{}{}\n", studies::qualification_text(gates), file.string());
  return std::all_of(gates.begin(), gates.end(), results::is_qualified) ? 0 : 1;
}

}  // namespace

void add_qualify_command(const command_line::Command& command, const Program& program, Action& action) {
  const auto configuration = add_configuration_option(command);
  const auto options = std::make_shared<QualifyOptions>();
  add_options(command, *options);
  command.footer(
      "Tests the gates by mutation: turns control images into faulty images (mutants) and judges all of them.\n"
      "It needs a run first: orbs run -r orbs.\n"
      "Exit status: 0 if every gate accepts the control image and rejects every mutant, 1 if one does not.");
  command.callback([=, &program, &action] {
    action = [=, &program] {
      return qualify(command, read_configuration(*configuration, program), *options, program);
    };
  });
}

}  // namespace orbs::cli

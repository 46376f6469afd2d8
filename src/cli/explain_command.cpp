#include "base/error.h"
#include "base/terminal.h"
#include "cli/options.h"
#include "cli/program.h"
#include "cli/run/run_options.h"
#include "cli/show_runs.h"
#include "registry/image_size.h"
#include "results/run_folder.h"
#include "run/plan/make_plan.h"
#include "studies/explain/explain.h"

#include <algorithm>

#include <fmt/format.h>

namespace orbs::cli {

namespace {

struct ExplainOptions {
  std::string folder;
  RunOptions run;
  std::vector<std::string> renderers;
  int threads = 0;
  studies::ExplainSettings explain;
};

void add_options(const command_line::Command& command, ExplainOptions& options) {
  constexpr int kMostThreads = 1024;
  command.add_option("run", options.folder, "Folder of the run (default: the newest outputs-*)");
  add_settings(command, options.run, {"case", "scene", "sandbox"});
  command
      .add_option("-r,--renderer", options.renderers,
                  "Only the images of these renderers (default: all that fail)")
      .separated_by(',');
  command
      .add_option("--spp-scale", options.explain.spp_scale,
                  "Samples of each render, as a share of those of the case")
      .above_zero()
      .shows_default();
  command.add_option("--threads", options.threads, "Threads; 0: all cores").range(0, kMostThreads);
}

int explain(const command_line::Command& command,
            const registry::Configuration& configuration,
            ExplainOptions options,
            const Program& program) {
  const auto folder = options.folder.empty() ? newest_runs().front() : std::filesystem::path(options.folder);
  const auto run = results::read_run_folder(folder).run;
  auto settings = study_settings(command, options.run, configuration.defaults);
  settings.suite = run.suite;
  settings.renderers = "orbs";
  settings.threads = options.threads;
  settings.jobs = 1;
  settings.size_divisor = registry::size_divisor(run.size);
  options.explain.renderers = options.renderers;
  const auto plan = run::make_plan(configuration, settings, program.folder);
  const auto context = study_context(program, stderr);
  const auto found = studies::explain(plan, run, options.explain, context);
  if (is_stopped(context)) return kInterrupted;
  if (found.empty()) {
    print_clean("no image of {} fails\n", folder.string());
    return 0;
  }
  print_clean("{}", studies::explanations_text(found));
  return std::all_of(found.begin(), found.end(), [](const auto& one) { return one.fault.has_value(); }) ? 0
                                                                                                        : 1;
}

}  // namespace

void add_explain_command(const command_line::Command& command, const Program& program, Action& action) {
  const auto configuration = add_configuration_option(command);
  const auto options = std::make_shared<ExplainOptions>();
  add_options(command, *options);
  command.footer(
      "Renders each scene whose image fails with the built-in tracer and one typical mistake after the other, such "
      "as an environment that is turned by a quarter, and names the mistake that makes the same image.\n"
      "Exit status: 0 if every wrong image is explained or none is wrong, 1 if one is not.");
  command.callback([=, &program, &action] {
    action = [=, &program] {
      return explain(command, read_configuration(*configuration, program), *options, program);
    };
  });
}

}  // namespace orbs::cli

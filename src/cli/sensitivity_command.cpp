#include "base/files.h"
#include "base/terminal.h"
#include "cli/options.h"
#include "cli/program.h"
#include "cli/run/run_options.h"
#include "registry/image_size.h"
#include "run/plan/make_plan.h"
#include "studies/looks/looks_text.h"
#include "studies/qualify/reports.h"

#include <filesystem>
#include <string>

#include <fmt/format.h>

namespace orbs::cli {

namespace {

struct SensitivityOptions {
  RunOptions run;
  std::string renderer = "orbs";
  int threads = 0;
  std::string counts;
  studies::LooksSettings looks{0};
  studies::SensitivitySettings study;
};

void add_options(const command_line::Command& command, SensitivityOptions& options) {
  constexpr int kMostThreads = 1024;
  constexpr int kMostRenders = 1000;
  add_settings(command, options.run, {"suite", "case", "scene", "size", "sandbox"});
  command.add_option("-r,--renderer", options.renderer, "Renderer of the control images").shows_default();
  command
      .add_option("--renders", options.study.renders,
                  "Renders of each scene with half its samples; each two of them are a control image")
      .range(2, kMostRenders)
      .shows_default();
  command.add_flag("!--no-faults", options.study.faults,
                   "Judge the control images alone; else the first becomes the slightly wrong images");
  command.add_option("--spp-scale", options.study.spp_scale, "Multiply the samples per pixel of the cases")
      .above_zero()
      .shows_default();
  command.add_option(
      "--counts", options.counts,
      "CSV file that gets a line for each kind of noise: control images judged, inconclusive, called "
      "wrong");
  command
      .add_option(
          "--looks", options.looks.sequences,
          "Simulate so many sequences of looks for each gate and error in place of renders: how often "
          "each is called wrong, and passed; `--counts` is then a CSV file of the table")
      .range(0, 10'000'000);
  command.add_option("--threads", options.threads, "Threads; 0: all cores").range(0, kMostThreads);
}

int simulate(const SensitivityOptions& options, const Program& program) {
  const auto context = study_context(program, stderr);
  auto settings = options.looks;
  settings.threads = options.threads;
  const auto rows = studies::simulate_looks(settings, context.stop);
  print_clean("{}", studies::looks_text(rows));
  if (!options.counts.empty() && !is_stopped(context)) write_file(options.counts, studies::looks_csv(rows));
  return is_stopped(context) ? kInterrupted : 0;
}

int measure(const command_line::Command& command,
            const registry::Configuration& configuration,
            const SensitivityOptions& options,
            const Program& program) {
  auto settings = study_settings(command, options.run, configuration.defaults);
  settings.renderers = options.renderer;
  settings.threads = options.threads;
  settings.jobs = 1;
  const auto plan = run::make_plan(configuration, settings, program.folder);
  const auto context = study_context(program, stderr);
  const auto images = studies::measure_sensitivity(plan, options.study, context);
  print_clean("{}", studies::sensitivity_text(images));
  if (!options.counts.empty() && !is_stopped(context)) {
    auto text = std::filesystem::exists(options.counts) ? read_file(options.counts)
                                                        : std::string(studies::kControlsCsvHead);
    text += studies::controls_csv(plan.suite.name, registry::size_text(plan.settings.size_divisor), images);
    write_file(options.counts, text);
  }
  return is_stopped(context) ? kInterrupted : 0;
}

}  // namespace

void add_sensitivity_command(const command_line::Command& command, const Program& program, Action& action) {
  const auto configuration = add_configuration_option(command);
  const auto options = std::make_shared<SensitivityOptions>();
  add_options(command, *options);
  command.footer(
      "Makes slightly wrong images of right ones and judges both: with variances, from two seeds, from one seed, "
      "and as a renderer without noise. It shows what passes silently, and how often a right image is called wrong.");
  command.callback([=, &program, &action] {
    action = [=, &program] {
      if (options->looks.sequences > 0) return simulate(*options, program);
      return measure(command, read_configuration(*configuration, program), *options, program);
    };
  });
}

}  // namespace orbs::cli

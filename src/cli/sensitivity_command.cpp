#include "base/terminal.h"
#include "cli/checks.h"
#include "cli/command_table.h"
#include "cli/options.h"
#include "cli/study_context.h"
#include "registry/image_size.h"
#include "run/plan/make_plan.h"
#include "studies/qualify/reports.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace orbs::cli {

namespace {

struct SensitivityOptions {
  TargetFilters filters;
  std::string renderer = "orbs";
  int threads = 0;
  std::string size;
  studies::SensitivitySettings study;
};

void add_options(CLI::App& command, SensitivityOptions& options) {
  constexpr int kMostThreads = 1024;
  constexpr int kMostControls = 10000;
  add_filter_options(command, options.filters);
  command.add_option("-r,--renderer", options.renderer, "Renderer of the control images")
      ->capture_default_str();
  command
      .add_option("--controls", options.study.controls,
                  "Control images of each scene; the first becomes the mutants")
      ->check(CLI::Range(1, kMostControls))
      ->capture_default_str();
  command.add_option("--spp-scale", options.study.spp_scale, "Factor of the cases' samples per pixel")
      ->check(above_zero())
      ->capture_default_str();
  add_size_option(command, options.size);
  command.add_option("--threads", options.threads, "Threads; 0: all cores")
      ->check(CLI::Range(0, kMostThreads));
}

int measure(const registry::Configuration& configuration,
            const SensitivityOptions& options,
            const Program& program) {
  auto settings = filtered_settings(configuration, options.filters);
  settings.renderers = options.renderer;
  settings.threads = options.threads;
  settings.size_divisor = options.size.empty() ? registry::FullSize : registry::size_divisor(options.size);
  settings.jobs = 1;
  const auto plan = run::make_plan(configuration, settings, program.folder);
  const auto context = study_context(program, stderr);
  print_clean("{}", studies::sensitivity_text(studies::measure_sensitivity(plan, options.study, context)));
  return is_stopped(context) ? kInterrupted : 0;
}

}  // namespace

void add_sensitivity_command(CLI::App& command, const Program& program, Action& action) {
  const auto configuration = add_configuration_option(command);
  const auto options = std::make_shared<SensitivityOptions>();
  add_options(command, *options);
  command.footer(
      "Makes slightly wrong images of right ones and judges both: with variances, from two seeds, from one seed,\n"
      "and as a renderer without noise. It shows what passes silently, and how often a right image is called wrong.");
  command.callback([=, &program, &action] {
    action = [=, &program] {
      return measure(read_configuration(*configuration, program), *options, program);
    };
  });
}

}  // namespace orbs::cli

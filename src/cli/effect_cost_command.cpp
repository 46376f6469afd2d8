#include "base/error.h"
#include "base/files.h"
#include "base/terminal.h"
#include "cli/options.h"
#include "cli/program.h"
#include "cli/run/run_options.h"
#include "results/effect_costs.h"
#include "studies/effects/effect_cost.h"
#include "studies/effects/report.h"

#include <fmt/format.h>
#include <unistd.h>

namespace orbs::cli {

namespace {

struct EffectCostOptions {
  studies::EffectCostSettings effect_costs;
  std::vector<std::string> scenes;
  RunOptions run;
  std::string output;
  bool as_markdown = false;
};

void add_options(const command_line::Command& command, EffectCostOptions& options) {
  command.add_option("scenes", options.scenes, "Scenes of the suite, by name or pattern (default: all)");
  add_settings(command, options.run, {"suite", "sandbox"});
  command.add_option("--rounds", options.effect_costs.rounds, "Rounds; each has its own seed")
      .range(2, 1000)
      .shows_default();
  command.add_option("--spp", options.effect_costs.spp, "Samples per pixel of each render")
      .range(8, 1 << 20)
      .shows_default();
  command.add_option("--side", options.effect_costs.size_px, "Longer side of the images in pixels")
      .range(16, 8192)
      .shows_default();
  refuse_size_in_pixels(command);
  command
      .add_option(
          "-o,--output", options.output,
          "File for all numbers (default: effect-costs.json in the working folder). Runs and their pages "
          "show the file that lies beside the references of the suite")
      .not_empty("a file");
  command.add_flag("--markdown", options.as_markdown, "Print the table as Markdown");
}

int measure(const command_line::Command& command,
            const registry::Configuration& configuration,
            const EffectCostOptions& options,
            const Program& program) {
  const auto file = options.output.empty() ? results::kEffectCostsFile : options.output;
  check_output_file(file);
  const auto settings = study_settings(command, options.run, configuration.defaults);
  const auto scenes = options.scenes.empty() ? "*" : joined_list(options.scenes);
  auto context = study_context(program, stderr);
  context.sandbox = settings.sandbox;
  const auto list =
      studies::measure_effect_costs(configuration, settings.suite, scenes, options.effect_costs, context);
  if (!list) return kInterrupted;
  write_file(file, studies::effect_cost_json(*list));
  print_clean("{}\nall numbers: {}\n",
              options.as_markdown ? studies::effect_cost_markdown(*list)
                                  : studies::effect_cost_table(*list, terminal_width(STDOUT_FILENO)),
              file);
  return studies::all_agree(*list) ? 0 : 1;
}

}  // namespace

void add_effect_cost_command(const command_line::Command& command, const Program& program, Action& action) {
  const auto configuration = add_configuration_option(command);
  const auto options = std::make_shared<EffectCostOptions>();
  add_options(command, *options);
  command.footer(
      "Renders each scene with every transport, and without each of its effects, with the built-in tracer.\n"
      "Exit status: 0 if every transport that carries enough gives the same image, 1 if one does not.");
  command.callback([=, &program, &action] {
    action = [=, &program] {
      return measure(command, read_configuration(*configuration, program), *options, program);
    };
  });
}

}  // namespace orbs::cli

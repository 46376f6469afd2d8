#include "base/error.h"
#include "base/files.h"
#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/not_empty.h"
#include "results/effect_costs.h"
#include "studies/effect_cost.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace orbs::cli {

namespace {

struct EffectsOptions {
  studies::EffectCostSettings effect_costs;
  std::vector<std::string> scenes;
  std::string suite;
  std::string output;
  bool as_markdown = false;
};

void add_options(CLI::App& command, EffectsOptions& options) {
  command.add_option("scenes", options.scenes,
                     "scenes of the suite by name or pattern (default: the whole suite)");
  command.add_option("--suite", options.suite, "the suite that has the scenes");
  command.add_option("--rounds", options.effect_costs.rounds, "rounds; each renders with its own seed")
      ->check(CLI::Range(2, 1000))
      ->capture_default_str();
  command.add_option("--spp", options.effect_costs.spp, "samples per pixel of each render")
      ->check(CLI::Range(8, 1 << 20))
      ->capture_default_str();
  command.add_option("--size", options.effect_costs.size_px, "longer side in pixels")
      ->check(CLI::Range(16, 8192))
      ->capture_default_str();
  command
      .add_option(
          "-o,--output", options.output,
          "file for all numbers (default: effect-costs.json in the working folder; beside the references "
          "of the suite, runs and their pages show it)")
      ->check(not_empty("a file"));
  command.add_flag("--markdown", options.as_markdown, "print the table in Markdown");
}

int effects(const registry::Configuration& configuration,
            const EffectsOptions& options,
            const Program& program) {
  const auto file = options.output.empty() ? results::kEffectCostsFile : options.output;
  check_output_file(file);
  studies::EffectCostContext context;
  context.build = program.folder;
  context.orbs_version = program.version;
  context.stop = &catch_interrupts();
  context.say = [](const std::string& line) { fmt::print(stderr, "{}\n", line); };
  const auto suite = options.suite.empty() ? configuration.defaults.suite : options.suite;
  const auto scenes = options.scenes.empty() ? "*" : joined_list(options.scenes);
  const auto list =
      studies::measure_effect_costs(configuration, suite, scenes, options.effect_costs, context);
  if (!list) return kInterrupted;
  write_file(file, studies::effect_cost_json(*list));
  fmt::print("{}\nall numbers: {}\n",
             options.as_markdown ? studies::effect_cost_markdown(*list) : studies::effect_cost_table(*list),
             file);
  return studies::all_agree(*list) ? 0 : 1;
}

}  // namespace

void add_effect_cost_command(CLI::App& app, const Program& program, Action& action) {
  auto* command = app.add_subcommand(
      "effect-cost",
      "Measures what effects of light cost: what richer transports cost, what poorer ones lose");
  const auto configuration = add_configuration_option(*command);
  const auto options = std::make_shared<EffectsOptions>();
  add_options(*command, *options);
  command->footer(
      "Renders with the built-in tracer. Exit status: 0 every richer transport gives the same image, 1 "
      "one does not.");
  command->callback([=, &program, &action] {
    action = [=, &program] {
      return effects(read_configuration(*configuration, program), *options, program);
    };
  });
}

}  // namespace orbs::cli

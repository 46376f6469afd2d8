#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/number_checks.h"
#include "references/references.h"

#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace orbs::cli {

void add_reference_command(CLI::App& app, const Program& program, Action& action) {
  auto* command = app.add_subcommand("reference", "Renders references with the built-in tracer");
  const auto configuration = add_configuration_option(*command);
  const auto settings = std::make_shared<references::ReferenceSettings>();
  const auto cases = std::make_shared<std::vector<std::string>>();
  const auto scenes = std::make_shared<std::vector<std::string>>();
  const auto suite = std::make_shared<std::string>();
  command->add_option("--suite", *suite, "the suite");
  command->add_option("-c,--case", *cases, "only the scenes of these cases");
  command->add_option("-s,--scene", *scenes, "only these scenes");
  command
      ->add_option("--spp", settings->spp,
                   "samples per pixel (default: until the noise is 10 dB below the gate)")
      ->check(CLI::Range(1, references::kMostReferenceSpp));
  command->add_option("--seed", settings->seed, "seed; keep it away from the seeds of runs")
      ->check(zero_or_more())
      ->capture_default_str();
  command->add_option("--threads", settings->threads, "0: all cores")->check(CLI::Range(0, 1024));
  command->add_option(
      "--accept", settings->reason,
      "why references that exist may be replaced; kept in their provenance records, and with those of "
      "the replaced ones in <scene>.history.json beside them");
  command->callback([=, &program, &action] {
    action = [=, &program] {
      const auto read = read_configuration(*configuration, program);
      auto selection = registry::RunSettings{};
      selection.suite = suite->empty() ? read.defaults.suite : *suite;
      if (!cases->empty()) selection.cases = joined_list(*cases);
      if (!scenes->empty()) selection.scenes = joined_list(*scenes);
      const auto& stop = catch_interrupts();
      // A file or a pipe would else get its first line after minutes.
      const auto say = [](const std::string& line) {
        fmt::print("{}\n", line);
        std::fflush(stdout);
      };
      return references::render_references(read, selection, *settings,
                                           {program.folder / "orbs-tracer", &stop, say});
    };
  });
}

}  // namespace orbs::cli

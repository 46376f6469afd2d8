#include "base/error.h"
#include "base/files.h"
#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/not_empty.h"
#include "studies/bench.h"
#include "studies/bench_report.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace orbs::cli {

namespace {

struct BenchOptions {
  studies::BenchSettings bench;
  std::vector<std::string> only;
  std::string output = "bench.json";
};

void add_options(CLI::App& command, BenchOptions& options) {
  command.add_option("--rounds", options.bench.rounds, "rounds; each renders with its own seed")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command
      .add_option("--spp", options.bench.spp, "samples per pixel of the large render; the small one has 1/8")
      ->check(CLI::Range(2, 1 << 20))
      ->capture_default_str();
  command.add_option("--size", options.bench.size_px, "width and height in pixels")
      ->check(CLI::Range(16, 8192))
      ->capture_default_str();
  command.add_option("--threads", options.bench.threads, "threads of each renderer")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command.add_option("--only", options.only,
                     "these renderers (default: orbs, and cycles where it is installed)");
  command.add_option("-o,--output", options.output, "file for all numbers")
      ->capture_default_str()
      ->check(not_empty("a file"));
}

int bench(const registry::Configuration& configuration, BenchOptions options, const Program& program) {
  check_output_file(options.output);
  options.bench.only = joined_list(options.only);
  studies::BenchContext context;
  context.build = program.folder;
  context.orbs_version = program.version;
  context.stop = &catch_interrupts();
  context.say = [](const std::string& line) { fmt::print(stderr, "{}\n", line); };
  const auto record = studies::run_bench(configuration, options.bench, context);
  if (!record) return kInterrupted;
  write_file(options.output, studies::bench_json(*record));
  fmt::print("\n{}\nall numbers: {}\n", studies::bench_table(*record), options.output);
  return 0;
}

}  // namespace

void add_bench_command(CLI::App& app, const Program& program, Action& action) {
  auto* command =
      app.add_subcommand("bench", "Measures speed and noise of renderers side by side, on the Cornell box");
  const auto configuration = add_configuration_option(*command);
  const auto options = std::make_shared<BenchOptions>();
  add_options(*command, *options);
  command->footer(
      "Leave the machine alone meanwhile: other work takes cache and clock from what is measured.");
  command->callback([=, &program, &action] {
    action = [=, &program] { return bench(read_configuration(*configuration, program), *options, program); };
  });
}

}  // namespace orbs::cli

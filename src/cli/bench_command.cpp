#include "base/error.h"
#include "base/files.h"
#include "base/terminal.h"
#include "cli/options.h"
#include "cli/program.h"
#include "studies/bench/bench.h"
#include "studies/bench/report.h"

#include <fmt/format.h>

namespace orbs::cli {

namespace {

struct BenchOptions {
  studies::BenchSettings bench;
  std::vector<std::string> only;
  std::string output = "bench.json";
};

void add_options(const command_line::Command& command, BenchOptions& options) {
  command.add_option("--rounds", options.bench.rounds, "Rounds; each has its own seed")
      .range(1, 1000)
      .shows_default();
  command
      .add_option("--spp", options.bench.spp,
                  "Samples per pixel of the large render; the small one takes 1/8 of them")
      .range(2, 1 << 20)
      .shows_default();
  command.add_option("--side", options.bench.size_px, "Width and height in pixels")
      .range(16, 8192)
      .shows_default();
  refuse_size_in_pixels(command);
  command.add_option("--threads", options.bench.threads, "Threads of each renderer")
      .range(1, 1024)
      .shows_default();
  command.add_option("--only", options.only,
                     "Renderers to measure (default: orbs, and cycles if it is installed)");
  command.add_option("-o,--output", options.output, "File for all numbers")
      .shows_default()
      .not_empty("a file");
}

int bench(const registry::Configuration& configuration, BenchOptions options, const Program& program) {
  refuse_without_sandbox(configuration.defaults.sandbox);
  check_output_file(options.output);
  options.bench.only = joined_list(options.only);
  const auto record = studies::run_bench(configuration, options.bench, study_context(program, stderr));
  if (!record) return kInterrupted;
  write_file(options.output, studies::bench_json(*record));
  print_clean("\n{}\nall numbers: {}\n", studies::bench_table(*record), options.output);
  return 0;
}

}  // namespace

void add_bench_command(const command_line::Command& command, const Program& program, Action& action) {
  const auto configuration = add_configuration_option(command);
  const auto options = std::make_shared<BenchOptions>();
  add_options(command, *options);
  command.footer("Renders the Cornell box. Run it on an idle machine: other work slows the renderers down.");
  command.callback([=, &program, &action] {
    action = [=, &program] { return bench(read_configuration(*configuration, program), *options, program); };
  });
}

}  // namespace orbs::cli

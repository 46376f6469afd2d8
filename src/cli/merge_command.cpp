#include "base/terminal.h"
#include "cli/program.h"
#include "report/files.h"
#include "report/table.h"
#include "run/cluster/merge_runs.h"

#include <string>
#include <vector>

#include <unistd.h>

namespace orbs::cli {

namespace {

struct Options {
  std::vector<std::string> shards;
  std::string output;
};

int merge(const Options& options, const Program& program) {
  const auto record =
      run::merge_runs({options.shards.begin(), options.shards.end()}, options.output, program.command_line);
  report::write_reports(record, record.folder);
  print_clean("\n{}\n{} renders of {} runs; results: {}\n",
              report::summary_text(record, report::style_for(STDOUT_FILENO)), record.jobs.size(),
              options.shards.size(), record.folder);
  return results::exit_status(record);
}

}  // namespace

void add_merge_command(const command_line::Command& command, const Program& program, Action& action) {
  const auto options = std::make_shared<Options>();
  command.add_option("runs", options->shards, "Folders of all shards of one run")
      .required()
      .not_empty("a folder");
  command
      .add_option("-o,--output", options->output,
                  "New folder for the whole run (default: outputs-YYMMDD-HHMMSS)")
      .value_name("FOLDER")
      .not_empty("a folder");
  command.footer(
      "Exit status: as orbs run; 2 if a render is missing or the shards contradict each other, which is listed.");
  command.callback([=, &program, &action] { action = [=, &program] { return merge(*options, program); }; });
}

}  // namespace orbs::cli

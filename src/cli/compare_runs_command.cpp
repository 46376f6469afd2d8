#include "base/terminal.h"
#include "cli/program.h"
#include "history/comparison_text.h"
#include "results/run_folder.h"

#include <string>

#include <unistd.h>

namespace orbs::cli {

namespace {

struct Options {
  std::string before;
  std::string after;
  bool as_markdown = false;
  bool as_json = false;
};

int compare(const Options& options) {
  const auto comparison = history::compare_runs(results::read_run_folder(options.before).run,
                                                results::read_run_folder(options.after).run);
  if (options.as_json) {
    print_raw(stdout, history::comparison_json(comparison));
  } else if (options.as_markdown) {
    print_clean("{}", history::comparison_markdown(comparison));
  } else {
    print_clean("{}", history::comparison_text(comparison, terminal_style(STDOUT_FILENO)));
  }
  return history::exit_status(comparison);
}

}  // namespace

void add_compare_runs_command(const command_line::Command& command,
                              const Program& /*program*/,
                              Action& action) {
  const auto options = std::make_shared<Options>();
  command.add_option("before", options->before, "Folder of the earlier run").required().not_empty("a folder");
  command.add_option("after", options->after, "Folder of the later run").required().not_empty("a folder");
  const auto markdown =
      command.add_flag("--markdown", options->as_markdown, "Print Markdown for a pull request");
  command.add_flag("--json", options->as_json, "Print everything as JSON, for programs").excludes(markdown);
  command.footer(
      "Exit status: 0 if nothing is worse; 1 if a verdict, a mean, an error or a time is worse, or a target of the "
      "earlier run vanished, was not rendered or cannot be compared any more; 2 if the runs cannot be compared.");
  command.callback([=, &action] { action = [=] { return compare(*options); }; });
}

}  // namespace orbs::cli

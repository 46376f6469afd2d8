#include "base/terminal.h"
#include "cli/program.h"
#include "history/comparison_text.h"
#include "results/run_folder.h"
#include "results/study_kinds.h"
#include "studies/cost/change_text.h"
#include "studies/cost/json.h"

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

bool is_cost_study(const std::string& folder) {
  const auto* const kind = results::study_kind_in(folder);
  return kind != nullptr && kind->name == results::kCost.name;
}

int compare_studies(const Options& options) {
  const auto read = [](const std::string& folder) {
    return studies::read_cost_file(std::filesystem::path(folder) / results::kCost.file);
  };
  const auto changes = studies::cost_changes(read(options.before), read(options.after));
  if (options.as_json) {
    print_raw(stdout, studies::changes_json(changes));
  } else if (options.as_markdown) {
    print_clean("{}", studies::changes_markdown(changes));
  } else {
    print_clean("{}", studies::changes_text(changes, terminal_style(STDOUT_FILENO)));
  }
  return studies::exit_status(changes);
}

int compare(const Options& options) {
  if (is_cost_study(options.before) && is_cost_study(options.after)) return compare_studies(options);
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
  command.add_option("before", options->before, "Folder of the earlier run or study of cost")
      .required()
      .not_empty("a folder");
  command.add_option("after", options->after, "Folder of the later run or study of cost")
      .required()
      .not_empty("a folder");
  const auto markdown =
      command.add_flag("--markdown", options->as_markdown, "Print Markdown for a pull request");
  command.add_flag("--json", options->as_json, "Print everything as JSON, for programs").excludes(markdown);
  command.footer(
      "Two studies of 'orbs cost' are compared by their times to an error.\n"
      "Exit status: 0 if nothing is worse; 1 if a verdict, a mean, an error or a time is worse, or a target of the "
      "earlier run vanished, was not rendered or cannot be compared any more; 2 if the runs cannot be compared.");
  command.callback([=, &action] { action = [=] { return compare(*options); }; });
}

}  // namespace orbs::cli

#include "base/files.h"
#include "base/terminal.h"
#include "cli/program.h"
#include "cli/show_runs.h"
#include "history/history_text.h"
#include "history/steps.h"
#include "report/history_page.h"
#include "results/run_folder.h"

#include <algorithm>
#include <string>
#include <vector>

#include <unistd.h>

namespace orbs::cli {

namespace {

struct Options {
  std::vector<std::string> runs;
  std::string page;
  bool as_markdown = false;
};

int show_history(const Options& options) {
  std::vector<std::filesystem::path> folders(options.runs.begin(), options.runs.end());
  if (folders.empty()) folders = newest_runs();
  if (!options.page.empty()) check_output_file(options.page);
  std::vector<results::RunRecord> runs;
  for (const auto& folder : folders) runs.push_back(results::read_run_folder(folder).run);
  const auto history = history::make_history(std::move(runs));
  const auto steps = history::find_steps(history);
  if (!options.page.empty()) write_file(options.page, report::history_page(history, steps));
  print_clean("{}", options.as_markdown
                        ? history::history_markdown(history, steps)
                        : history::history_text(history, steps, terminal_style(STDOUT_FILENO)));
  const bool is_worse = std::any_of(steps.begin(), steps.end(), [](const history::Change& step) {
    return step.direction == history::Direction::Worse;
  });
  return is_worse ? 1 : 0;
}

}  // namespace

void add_history_command(const command_line::Command& command, const Program& /*program*/, Action& action) {
  const auto options = std::make_shared<Options>();
  command.add_option("runs", options->runs, "Folders of runs (default: all outputs-* in the working folder)")
      .not_empty("a folder");
  command.add_option("-o,--output", options->page, "Also write the history as a page, one HTML file")
      .value_name("FILE")
      .not_empty("a file");
  command.add_flag("--markdown", options->as_markdown, "Print the tables as Markdown");
  command.footer("Exit status: 0 if no step is worse, 1 if one is, 2 if there is no run.");
  command.callback([=, &action] { action = [=] { return show_history(*options); }; });
}

}  // namespace orbs::cli

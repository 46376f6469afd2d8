#include "base/error.h"
#include "base/terminal.h"
#include "base/text.h"
#include "base/text_table.h"
#include "cli/program.h"
#include "cli/show_runs.h"
#include "report/report_card.h"
#include "results/run_folder.h"
#include "results/study_kinds.h"
#include "studies/cost/json.h"
#include "studies/cost/numbers.h"
#include "studies/cost/report.h"
#include "studies/cost/time_to_error.h"
#include "studies/stability/json.h"
#include "studies/stability/report.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

namespace orbs::cli {

namespace {

namespace fs = std::filesystem;

struct CardOptions {
  std::string renderer;
  std::vector<std::string> folders;
};

using Rows = std::vector<TableRow>;

// The row of a heading has the question; what follows on the same question has none.
void add_row(const char* question, const std::string& text, const std::string& source, Rows& rows) {
  rows.push_back({question, text, source});
}

// Whether it is right, as on the page. False where the run says nothing of it.
bool add_verdict(const fs::path& folder, const std::string& renderer, Rows& rows) {
  const auto run = results::read_run_folder(folder).run;
  for (const auto& card : report::report_cards(run)) {
    if (card.renderer != renderer) continue;
    const auto name = folder.filename().string();
    add_row("right?", card.sentence, name, rows);
    for (const auto& group : card.groups)
      add_row("", fmt::format("{} {}: {}", group.targets.size(), group.state, group.what), "", rows);
    if (card.cost) add_row("cost?", card.cost->sentence, name, rows);
    if (!card.clock.empty()) add_row(card.cost ? "" : "cost?", card.clock, name, rows);
    return true;
  }
  return false;
}

// "takes 6.30 (4.80 to 8.20) times the CPU time of orbs to 35 dB, 15 targets", a line for each other
// renderer.
bool add_cost(const fs::path& folder, const std::string& renderer, Rows& rows) {
  const auto record = studies::read_cost_file(folder / results::kCost.file);
  const auto numbers = studies::cost_numbers(record);
  const auto error = studies::error_targets().at(studies::main_error(record));
  bool is_said = false;
  for (const auto& mean : numbers.mean_ratios) {
    const auto& first = record.renderers.at(mean.first).name;
    const auto& second = record.renderers.at(mean.second).name;
    if (studies::error_text(mean.error) != studies::error_text(error) ||
        (first != renderer && second != renderer))
      continue;
    const bool is_second = second == renderer;
    const auto& ratio = mean.time_ratio;
    const Interval own = is_second ? ratio : Interval{1 / ratio.value, 1 / ratio.high, 1 / ratio.low};
    add_row(is_said ? "" : "cost?",
            fmt::format("takes {} times the CPU time of {} to {}, {} targets", studies::ratio_text(own),
                        is_second ? first : second, studies::error_text(error), mean.scenes),
            folder.filename().string(), rows);
    is_said = true;
  }
  return is_said;
}

bool add_stability(const fs::path& folder, const std::string& renderer, Rows& rows) {
  const auto record = studies::read_stability_file(folder / results::kStability.file);
  for (std::size_t i = 0; i < record.renderers.size(); ++i) {
    if (record.renderers[i].name != renderer) continue;
    auto text = studies::stability_summary(record, i);
    const auto start = renderer + ": ";
    if (text.starts_with(start)) text = text.substr(start.size());
    add_row("stays right?", text, folder.filename().string(), rows);
    return true;
  }
  return false;
}

// The newest that says something answers each question, as on the page.
Rows answers(const std::vector<fs::path>& folders, const std::string& renderer) {
  Rows verdict;
  Rows cost;
  Rows stability;
  for (const auto& folder : folders) {
    const auto* const kind = results::study_kind_in(folder);
    if (kind == nullptr) {
      if (verdict.empty()) add_verdict(folder, renderer, verdict);
    } else if (kind->name == results::kCost.name) {
      if (cost.empty()) add_cost(folder, renderer, cost);
    } else if (stability.empty()) {
      add_stability(folder, renderer, stability);
    }
  }
  const auto of_run =
      std::find_if(verdict.begin(), verdict.end(), [](const auto& row) { return row[0] == "cost?"; });
  if (cost.empty()) cost.assign(of_run, verdict.end());
  verdict.erase(of_run, verdict.end());
  if (verdict.empty()) add_row("right?", "not known: orbs run judges it", "", verdict);
  if (cost.empty()) add_row("cost?", "not known: orbs cost measures it", "", cost);
  if (stability.empty()) add_row("stays right?", "not known: orbs stability measures it", "", stability);
  verdict.insert(verdict.end(), cost.begin(), cost.end());
  verdict.insert(verdict.end(), stability.begin(), stability.end());
  return verdict;
}

int card(const CardOptions& options) {
  const auto folders = options.folders.empty()
                           ? newest_runs_and_studies()
                           : std::vector<fs::path>(options.folders.begin(), options.folders.end());
  const auto rows = answers(folders, options.renderer);
  if (std::all_of(rows.begin(), rows.end(), [](const auto& row) { return row[1].starts_with("not known"); }))
    throw InputError(
        fmt::format("no run and no study of {} has a renderer '{}'; 'orbs run -r {}' makes one",
                    options.folders.empty() ? fs::current_path().string() : options.folders.front(),
                    options.renderer, options.renderer));
  print_clean("{}\n{}", options.renderer, text_table(rows, {}, {terminal_width(STDOUT_FILENO), {}}));
  return 0;
}

}  // namespace

void add_card_command(const command_line::Command& command, const Program& /*program*/, Action& action) {
  const auto options = std::make_shared<CardOptions>();
  command.add_option("renderer", options->renderer, "Name of a renderer").required().not_empty("a name");
  command.add_option("folders", options->folders,
                     "Folders of runs and studies, the newest first (default: all in the working folder)");
  command.footer(
      "Says of one renderer whether it is right, what being right costs, and whether it stays right when numbers get "
      "hard: each by the newest run or study that knows, as the page does.");
  command.callback([=, &action] { action = [=] { return card(*options); }; });
}

}  // namespace orbs::cli

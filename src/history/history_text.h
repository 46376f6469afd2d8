#pragma once

#include "base/terminal.h"
#include "history/change.h"
#include "history/series.h"
#include "results/verdict.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace orbs::history {

/// What a line about one target says.
struct SeriesSummary {
  std::string states;  // "pass 11, fail 1", the best first
  std::string now;     // the state in the newest run that has it
  bool is_flaky = false;
  std::optional<double> median_db, newest_db;
  std::optional<double> median_seconds, newest_seconds;
};

SeriesSummary summary_of(const Series& series);

/// "3 runs of suite orbs at 1/4, 2026-01-01 to 2026-01-03".
std::string headline(const History& history);

/// The names of targets whose verdicts differ between seeds, as "cycles 101"; each once.
std::vector<std::string> flaky_targets(const History& history);

/// Steps, the worst first; flaky targets; a line for each target; what was left out.
std::string history_text(const History& history,
                         const std::vector<Change>& steps,
                         const TerminalStyle& style);

/// The same as Markdown.
std::string history_markdown(const History& history, const std::vector<Change>& steps);

}  // namespace orbs::history

// The verdicts of all renderers side by side: docs/reports/renderers-1-4.csv, which
// data/bench/renderer_results.py makes of runs, and the tables of the README and of the findings that are
// made of it.
#include "base/files.h"
#include "structure/documentation.h"

#include <algorithm>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace {

struct Column {
  std::string renderer;
  std::string version;
  std::string cpu_seconds;
  std::string measured;
  std::map<std::string, std::string> cells{};  // by requirement
};

struct Table {
  std::vector<Column> columns;
  std::vector<std::pair<std::string, std::string>> requirements;  // code and title
};

std::string cell_text(const std::string& verdict, const std::string& psnr_db) {
  if (verdict == "unsupported") return "\u2013";
  const bool is_pass = verdict.starts_with("pass");
  const char* mark = is_pass ? "\u2713" : verdict == "inconclusive" ? "?" : "\u2717";
  return fmt::format("{} {}", psnr_db, mark);
}

// Titles that have a comma are quoted.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  bool is_quoted = false;
  for (const char c : line) {
    if (c == '"') {
      is_quoted = !is_quoted;
    } else if (c == ',' && !is_quoted) {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

Table read_table(const std::string& csv) {
  Table table;
  std::istringstream in(csv);
  std::string line;
  std::getline(in, line);  // the names of the columns
  while (std::getline(in, line)) {
    const auto cells = cells_of(line);
    if (cells.size() != 8) throw std::runtime_error("renderers-1-4.csv: expected 8 cells: " + line);
    if (table.columns.empty() || table.columns.back().renderer != cells[0])
      table.columns.push_back({cells[0], cells[1], cells[2], cells[3]});
    const std::pair requirement{cells[4], cells[5]};
    if (std::find(table.requirements.begin(), table.requirements.end(), requirement) ==
        table.requirements.end())
      table.requirements.push_back(requirement);
    table.columns.back().cells[cells[4]] = cell_text(cells[6], cells[7]);
  }
  return table;
}

template <typename CellOf>
std::string row(const Table& table, const std::string& head, CellOf cell_of) {
  std::string text = fmt::format("| {} |", head);
  for (const auto& column : table.columns) text += fmt::format(" {} |", cell_of(column));
  return text + "\n";
}

std::string markdown(const Table& table) {
  auto text = row(table, "", [](const Column& column) { return column.renderer; });
  text += "|---|";
  for (std::size_t i = 0; i < table.columns.size(); ++i) text += "---|";
  text += '\n';
  for (const auto& [code, title] : table.requirements)
    text += row(table, fmt::format("{} {}", code, title), [&](const Column& column) {
      const auto cell = column.cells.find(code);
      return cell == column.cells.end() ? std::string("\u2013") : cell->second;
    });
  return text + row(table, "CPU seconds", [](const Column& column) { return column.cpu_seconds; });
}

std::string versions(const Table& table) {
  std::string text = "| renderer | version | measured at 1/4 |\n|---|---|---|\n";
  for (const auto& column : table.columns)
    text += fmt::format("| {} | {} | {} |\n", column.renderer,
                        column.version.empty() ? "not told" : column.version, column.measured);
  return text;
}

}  // namespace

TEST(RenderersTable, TheReadmeAndTheFindingsShowTheCommittedRuns) {
  const std::filesystem::path root(ORBS_SOURCE_DIR);
  const auto table = read_table(orbs::read_file(root / "docs/reports/renderers-1-4.csv"));
  ASSERT_GE(table.columns.size(), 6U) << "the built-in tracer, Cycles, POV-Ray, Mitsuba, pbrt and HydraCore3";
  using orbs::structure::check_generated_part;
  EXPECT_EQ(check_generated_part(root / "README.md", "renderers", markdown(table)), "");
  EXPECT_EQ(check_generated_part(root / "docs/reports/findings.md", "renderers",
                                 markdown(table) + "\n" + versions(table)),
            "");
}

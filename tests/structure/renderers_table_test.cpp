// The verdicts of all renderers side by side: docs/reports/renderers-1-4.csv and gltf-*.csv beside it, which
// data/bench/renderer_results.py makes of runs, and the tables of the README, of the findings and of the page
// of the renderers that are made of them.
#include "base/files.h"
#include "registry/configuration.h"
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
    if (cells.size() != 8) throw std::runtime_error("expected 8 cells: " + line);
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
  const auto has_times = [](const Column& column) { return !column.cpu_seconds.empty(); };
  if (std::none_of(table.columns.begin(), table.columns.end(), has_times)) return text;
  return text + row(table, "CPU seconds", [](const Column& column) { return column.cpu_seconds; });
}

// Scenes whose failures have one cause share a row.
std::string causes(const std::vector<orbs::registry::ExpectedFailure>& expected,
                   const std::string& renderer) {
  std::vector<std::pair<std::pair<std::string, std::string>, std::string>> rows;
  for (const auto& entry : expected) {
    if (entry.renderer != renderer) continue;
    const std::pair key{entry.verdict, entry.reason};
    const auto found =
        std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row.first == key; });
    if (found == rows.end()) {
      rows.emplace_back(key, entry.scene);
    } else {
      found->second += "," + entry.scene;
    }
  }
  std::string text = "| scenes | verdict | cause |\n|---|---|---|\n";
  for (auto& [key, scenes] : rows) {
    for (auto comma = scenes.find(','); comma != std::string::npos; comma = scenes.find(',', comma + 2))
      scenes.insert(comma + 1, " ");
    text += fmt::format("| {} | {} | {} |\n", scenes, key.first, key.second);
  }
  return text;
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

TEST(RenderersTable, ThePageOfTheRenderersShowsWhatReadersOfGltfDrawAndWhyItDiffers) {
  const std::filesystem::path root(ORBS_SOURCE_DIR);
  const auto expected = orbs::registry::load_configuration(root / "configuration.json").expected;
  for (const auto& [renderer, size] : {std::pair{"cycles-gltf", "1-4"}}) {
    const auto table = read_table(orbs::read_file(root / fmt::format("docs/reports/gltf-{}.csv", size)));
    ASSERT_EQ(table.columns.size(), 1U) << size;
    EXPECT_EQ(table.columns[0].renderer, renderer);
    EXPECT_EQ(orbs::structure::check_generated_part(root / "docs/use/renderers.md", renderer,
                                                    markdown(table) + "\n" + causes(expected, renderer)),
              "");
  }
}

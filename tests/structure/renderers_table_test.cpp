// The verdicts of all renderers side by side: docs/reports/renderers-1-4.csv, everyday-1-4.csv and gltf-*.csv
// beside it, which data/bench/renderer_results.py makes of runs, and the tables of the README, of the
// findings and of the page of the renderers that are made of them.
#include "base/files.h"
#include "registry/configuration.h"
#include "structure/documentation.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace {

// How many scenes of each verdict.
enum Verdict : std::size_t { kPass, kFail, kInconclusive, kUnsupported, kVerdicts };
constexpr std::array<const char*, kVerdicts> kMarks{"\u2713", "\u2717", "?", "\u2013"};
using Counts = std::array<int, kVerdicts>;

struct Column {
  std::string renderer;
  std::string version;
  std::string cpu_seconds;
  std::string measured;
  std::map<std::string, std::string> cells{};  // by requirement
  Counts scenes{};                             // where the file counts them
};

struct Table {
  std::vector<Column> columns;
  std::vector<std::pair<std::string, std::string>> requirements;  // code and title
  std::string numbers{};  // what the cells hold, the name of their column
};

// Files of earlier runs hold one number, which is that of the image or without its noise.
std::string what_numbers_are(const Table& table) {
  if (table.numbers == "psnr_db") return "Numbers are the least PSNR of a requirement's images in dB.\n";
  return "Numbers are the least PSNR of a requirement's images in dB, without their noise if that decided.\n";
}

std::string cell_text(const std::string& verdict, const std::string& psnr_db) {
  if (verdict == "unsupported") return "\u2013";
  const bool is_pass = verdict.starts_with("pass");
  const char* mark = is_pass ? "\u2713" : verdict == "inconclusive" ? "?" : "\u2717";
  return fmt::format("{} {}", psnr_db, mark);
}

// Where scenes of one requirement have several verdicts, how many have each.
std::string counted_text(const std::string& psnr_db, const Counts& counts) {
  std::string marks;
  int kinds = 0;
  for (std::size_t verdict = 0; verdict < kVerdicts; ++verdict) {
    if (counts[verdict] == 0) continue;
    marks += fmt::format(" {}\u00a0{}", kMarks[verdict], counts[verdict]);
    ++kinds;
  }
  if (kinds == 1) {
    const auto only = std::find_if(counts.begin(), counts.end(), [](int count) { return count > 0; });
    marks = fmt::format(" {}", kMarks[static_cast<std::size_t>(only - counts.begin())]);
  }
  if (counts[kPass] + counts[kFail] + counts[kInconclusive] == 0) return kMarks[kUnsupported];
  return (psnr_db == "inf" ? "\u221e" : psnr_db) + marks;
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
  table.numbers = cells_of(line).at(7);
  while (std::getline(in, line)) {
    const auto cells = cells_of(line);
    const bool has_counts = cells.size() == 8 + kVerdicts;
    if (cells.size() != 8 && !has_counts)
      throw std::runtime_error(fmt::format("expected 8 or {} cells: {}", 8 + kVerdicts, line));
    if (table.columns.empty() || table.columns.back().renderer != cells[0])
      table.columns.push_back({cells[0], cells[1], cells[2], cells[3]});
    const std::pair requirement{cells[4], cells[5]};
    if (std::find(table.requirements.begin(), table.requirements.end(), requirement) ==
        table.requirements.end())
      table.requirements.push_back(requirement);
    auto& column = table.columns.back();
    if (!has_counts) {
      column.cells[cells[4]] = cell_text(cells[6], cells[7]);
      continue;
    }
    Counts counts{};
    for (std::size_t verdict = 0; verdict < kVerdicts; ++verdict) {
      counts[verdict] = std::stoi(cells[8 + verdict]);
      column.scenes[verdict] += counts[verdict];
    }
    column.cells[cells[4]] = counted_text(cells[7], counts);
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
  if (std::any_of(table.columns.begin(), table.columns.end(), has_times))
    text += row(table, "CPU seconds", [](const Column& column) { return column.cpu_seconds; });
  return text + "\n" + what_numbers_are(table);
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

std::string versions_and_counts(const Table& table) {
  std::string text = "| renderer | version | scenes |";
  for (const char* mark : kMarks) text += fmt::format(" {} |", mark);
  text += "\n|---|---|---|---|---|---|---|\n";
  for (const auto& column : table.columns) {
    text +=
        fmt::format("| {} | {} | {} |", column.renderer, column.version.empty() ? "not told" : column.version,
                    std::accumulate(column.scenes.begin(), column.scenes.end(), 0));
    for (const int count : column.scenes) text += fmt::format(" {} |", count);
    text += '\n';
  }
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

TEST(RenderersTable, TheFindingsShowTheCommittedRunsOfEverydayFeatures) {
  const std::filesystem::path root(ORBS_SOURCE_DIR);
  const auto table = read_table(orbs::read_file(root / "docs/reports/everyday-1-4.csv"));
  ASSERT_FALSE(table.columns.empty());
  EXPECT_EQ(table.columns[0].renderer, "orbs");
  for (const auto& column : table.columns)
    EXPECT_EQ(std::accumulate(column.scenes.begin(), column.scenes.end(), 0),
              std::accumulate(table.columns[0].scenes.begin(), table.columns[0].scenes.end(), 0))
        << column.renderer << " was not run in all scenes";
  EXPECT_EQ(orbs::structure::check_generated_part(root / "docs/reports/findings.md", "everyday",
                                                  markdown(table) + "\n" + versions_and_counts(table)),
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

// With Blender 4.3 the shipped entries said "known" of what was so in 3.4 only.
TEST(KnownFailures, OfRenderersThatTellTheirVersionAreOfVersions) {
  const auto configuration =
      orbs::registry::load_configuration(std::filesystem::path(ORBS_SOURCE_DIR) / "configuration.json");
  std::map<std::string, bool> tells;
  for (const auto& renderer : configuration.renderers)
    tells[renderer.name] = !renderer.command.version_command.empty();
  ASSERT_GE(configuration.expected.size(), 80U);
  for (const auto& entry : configuration.expected) {
    ASSERT_TRUE(tells.contains(entry.renderer)) << entry.place;
    EXPECT_EQ(is_absent(entry.version), !tells.at(entry.renderer)) << entry.place << ": " << entry.scene;
  }
}

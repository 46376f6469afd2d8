#include "base/terminal.h"
#include "base/text.h"
#include "base/text_table.h"
#include "cli/options.h"
#include "cli/program.h"
#include "cli/run/run_options.h"
#include "json/writer.h"
#include "registry/cases.h"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

namespace orbs::cli {

namespace {

using registry::Case;
using registry::Configuration;

// One list: its rows as text, and what the columns are called in JSON.
struct Table {
  const char* name;
  const char* columns;  // for the heading
  std::vector<std::string> keys;
  std::vector<TableRow> rows;
};

Table suites(const Configuration& configuration) {
  Table table{"suites", "name, folder of its cases", {"name", "cases"}, {}};
  for (const auto& suite : configuration.suites) table.rows.push_back({suite.name, suite.cases.string()});
  return table;
}

Table renderers(const Configuration& configuration) {
  Table table{"renderers", "name, what it declares, program", {"name", "declares", "executable"}, {}};
  for (const auto& renderer : configuration.renderers)
    table.rows.push_back(
        {renderer.name, registry::format_features(renderer.support.declares), renderer.command.executable});
  return table;
}

Table requirements(const std::vector<Case>& cases) {
  Table table{"requirements", "code, title", {"code", "title"}, {}};
  for (const auto& one_case : cases)
    if (table.rows.empty() || table.rows.back()[0] != one_case.requirement)
      table.rows.push_back({one_case.requirement, one_case.title});
  return table;
}

Table case_table(const std::vector<Case>& cases) {
  Table table{"cases", "name, requirement, title, targets", {"name", "requirement", "title", "targets"}, {}};
  for (const auto& one_case : cases)
    table.rows.push_back({one_case.name, one_case.requirement, one_case.title,
                          fmt::format("{}", fmt::join(registry::target_names(one_case), ", "))});
  return table;
}

Table scenes(const std::vector<Case>& cases) {
  Table table{"scenes",
              "name, requirement, samples, file or difference",
              {"name", "requirement", "samples", "file"},
              {}};
  std::set<std::string> seen;
  for (const auto& one_case : cases) {
    for (const auto& scene : one_case.scenes)
      if (seen.insert(scene.name).second)
        table.rows.push_back(
            {scene.name, one_case.requirement, fmt::format("{} spp", scene.spp), scene.file.string()});
    for (const auto& difference : one_case.differences)
      table.rows.push_back({difference.name, one_case.requirement, "",
                            fmt::format("{} - {}", difference.of, difference.minus)});
  }
  return table;
}

std::vector<Table> wanted_tables(const Configuration& configuration,
                                 const std::string& suite,
                                 const std::string& what) {
  const auto wants = [&](std::string_view name) { return what == "all" || what == name; };
  std::vector<Table> tables;
  if (wants("suites")) tables.push_back(suites(configuration));
  if (wants("renderers")) tables.push_back(renderers(configuration));
  if (what == "suites" || what == "renderers") return tables;
  const auto cases = registry::load_cases(registry::find_suite(configuration, suite));
  if (wants("requirements")) tables.push_back(requirements(cases));
  if (wants("cases")) tables.push_back(case_table(cases));
  if (wants("scenes")) tables.push_back(scenes(cases));
  return tables;
}

// A single list has no heading, so that scripts can read it.
void print(const std::vector<Table>& tables) {
  const TableLook look{terminal_width(STDOUT_FILENO), {}};
  const char* before = "";
  for (const auto& table : tables) {
    if (tables.size() > 1) print_clean("{}{} ({})\n", before, table.name, table.columns);
    print_clean("{}", text_table(table.rows, {}, look));
    before = "\n";
  }
}

// Names hold no comma, so the targets of a case can be told apart.
void write_row(json::Writer& out, const Table& table, const TableRow& row) {
  out.begin_object();
  for (std::size_t i = 0; i < row.size(); ++i) {
    const auto& key = table.keys[i];
    if (key == "targets") {
      std::vector<std::string> targets;
      for (const auto& target : split(row[i], ',')) targets.emplace_back(trim(target));
      out.member(key, targets);
    } else if (!row[i].empty()) {
      out.member(key, row[i]);
    }
  }
  out.end_object();
}

void print_json(const std::vector<Table>& tables) {
  json::Writer out;
  out.begin_object().member("format", "orbs-list/1");
  for (const auto& table : tables) {
    out.key(table.name).begin_array();
    for (const auto& row : table.rows) write_row(out, table, row);
    out.end_array();
  }
  print_raw(stdout, out.end_object().text());
}

}  // namespace

void add_list_command(const command_line::Command& command, const Program& program, Action& action) {
  const auto configuration = add_configuration_option(command);
  const auto what = std::make_shared<std::string>("all");
  const auto run = std::make_shared<RunOptions>();
  command.add_option("what", *what, "Which list to print")
      .one_of({"all", "suites", "renderers", "requirements", "cases", "scenes"});
  add_settings(command, *run, {"suite"});
  const auto as_json = std::make_shared<bool>(false);
  command.add_flag("--json", *as_json, "Print everything as JSON, for programs");
  command.callback([=, &program, &action] {
    action = [=, &program] {
      const auto read = read_configuration(*configuration, program);
      const auto tables = wanted_tables(read, run_settings(command, *run, read.defaults).suite, *what);
      if (*as_json) {
        print_json(tables);
      } else {
        print(tables);
      }
      return 0;
    };
  });
}

}  // namespace orbs::cli

#include "base/text_table.h"
#include "cli/command_table.h"
#include "cli/options.h"
#include "registry/cases.h"

#include <algorithm>
#include <map>
#include <set>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::cli {

namespace {

using registry::Case;
using registry::Configuration;

void print_columns(const std::vector<std::vector<std::string>>& rows) { fmt::print("{}", text_table(rows)); }

void list_suites(const Configuration& configuration) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& suite : configuration.suites) rows.push_back({suite.name, suite.cases.string()});
  print_columns(rows);
}

void list_cases(const std::vector<Case>& cases) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& one_case : cases)
    rows.push_back({one_case.name, one_case.requirement, one_case.title,
                    fmt::format("{}", fmt::join(registry::target_names(one_case), ", "))});
  print_columns(rows);
}

void list_requirements(const std::vector<Case>& cases) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& one_case : cases)
    if (rows.empty() || rows.back()[0] != one_case.requirement)
      rows.push_back({one_case.requirement, one_case.title});
  print_columns(rows);
}

void list_scenes(const std::vector<Case>& cases) {
  std::vector<std::vector<std::string>> rows;
  std::set<std::string> seen;
  for (const auto& one_case : cases) {
    for (const auto& scene : one_case.scenes)
      if (seen.insert(scene.name).second)
        rows.push_back(
            {scene.name, one_case.requirement, fmt::format("{} spp", scene.spp), scene.file.string()});
    for (const auto& difference : one_case.differences)
      rows.push_back({difference.name, one_case.requirement, "",
                      fmt::format("{} - {}", difference.of, difference.minus)});
  }
  print_columns(rows);
}

void list_renderers(const Configuration& configuration) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& renderer : configuration.renderers)
    rows.push_back({renderer.name, registry::format_features(renderer.declares), renderer.executable});
  print_columns(rows);
}

int list(const Configuration& configuration, const std::string& suite, const std::string& what) {
  const bool all = what == "all";
  // A single list has no heading, so that scripts can read it.
  const auto wants = [&](std::string_view title, const char* columns) {
    if (!all && what != title) return false;
    if (all) fmt::print("{}{} ({})\n", title == "suites" ? "" : "\n", title, columns);
    return true;
  };
  if (wants("suites", "name, folder of its cases")) list_suites(configuration);
  if (wants("renderers", "name, what it declares, program")) list_renderers(configuration);
  if (what == "suites" || what == "renderers") return 0;
  const auto cases = registry::load_cases(registry::find_suite(configuration, suite));
  if (wants("requirements", "code, title")) list_requirements(cases);
  if (wants("cases", "name, requirement, title, targets")) list_cases(cases);
  if (wants("scenes", "name, requirement, samples, file or difference")) list_scenes(cases);
  return 0;
}

}  // namespace

void add_list_command(CLI::App& command, const Program& program, Action& action) {
  const auto configuration = add_configuration_option(command);
  const auto what = std::make_shared<std::string>("all");
  const auto suite = std::make_shared<std::string>();
  command.add_option("what", *what, "Which list to print")
      ->check(CLI::IsMember({"all", "suites", "renderers", "requirements", "cases", "scenes"}));
  command.add_option("--suite", *suite, "The suite (default: that of the configuration)");
  command.callback([=, &program, &action] {
    action = [=, &program] {
      const auto read = read_configuration(*configuration, program);
      return list(read, suite->empty() ? read.defaults.suite : *suite, *what);
    };
  });
}

}  // namespace orbs::cli

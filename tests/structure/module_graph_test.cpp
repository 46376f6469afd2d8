// docs/understand/architecture.md draws the modules as src/CMakeLists.txt lists them.
#include "structure/documentation.h"
#include "structure/source_files.h"

#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace fs = std::filesystem;

namespace {

using Uses = std::map<std::string, std::set<std::string>>;

struct Modules {
  std::vector<std::string> order;
  Uses uses;
};

// The lines "orbs_module(name USES a b PACKAGES c)". Each stands on one line of its own.
Modules read_modules(const fs::path& list) {
  Modules modules;
  for (auto line : orbs::structure::lines_of(list)) {
    if (!line.starts_with("orbs_module(")) continue;
    for (char& c : line)
      if (c == '(' || c == ')') c = ' ';
    std::istringstream words(line);
    std::string word;
    words >> word >> word;
    modules.order.push_back(word);
    auto& uses = modules.uses[word];
    bool is_used = false;
    while (words >> word) {
      if (word == "USES" || word == "PACKAGES")
        is_used = word == "USES";
      else if (is_used)
        uses.insert(word);
    }
  }
  return modules;
}

bool reaches(const Uses& uses, const std::string& from, const std::string& to) {
  for (const auto& next : uses.at(from))
    if (next == to || reaches(uses, next, to)) return true;
  return false;
}

// Arrows that follow from two others are left out: with them nobody could read the graph.
std::string drawing_of(const Modules& modules) {
  std::string out = "```mermaid\nflowchart BT\n";
  for (const auto& module : modules.order) {
    out += fmt::format("  {}\n", module);
    const auto& uses = modules.uses.at(module);
    for (const auto& used : uses) {
      bool follows = false;
      for (const auto& other : uses)
        follows = follows || (other != used && reaches(modules.uses, other, used));
      if (!follows) out += fmt::format("  {} --> {}\n", module, used);
    }
  }
  return out + "```\n";
}

}  // namespace

TEST(ModuleGraph, IsThatOfTheUsesLists) {
  const fs::path root = ORBS_SOURCE_DIR;
  const auto modules = read_modules(root / "src/CMakeLists.txt");
  ASSERT_GE(modules.order.size(), 10u) << "src/CMakeLists.txt is no longer read correctly";
  EXPECT_EQ(orbs::structure::check_generated_part(root / "docs/understand/architecture.md", "modules",
                                                  drawing_of(modules)),
            "");
}

TEST(ModuleGraph, EachModuleHasARowThatSaysWhatItHolds) {
  const fs::path root = ORBS_SOURCE_DIR;
  const auto rows = orbs::structure::section(
      orbs::structure::read_page(root / "docs/understand/architecture.md"), "## What each module holds");
  std::set<std::string> described;
  for (const auto& row : rows)
    if (row.starts_with("| `src/")) described.insert(row.substr(7, row.find('`', 7) - 7));
  std::set<std::string> listed;
  for (const auto& module : read_modules(root / "src/CMakeLists.txt").order) listed.insert(module);
  EXPECT_EQ(described, listed);
}

TEST(ModuleGraph, ArrowsThatFollowFromOthersAreLeftOut) {
  const orbs::structure::TestFolder scratch("module-graph");
  scratch.write("CMakeLists.txt",
                "orbs_module(base PACKAGES Threads::Threads)\norbs_module(json USES base)\n"
                "orbs_module(scene  USES base json PACKAGES x)\n");
  EXPECT_EQ(drawing_of(read_modules(scratch.path() / "CMakeLists.txt")),
            "```mermaid\nflowchart BT\n  base\n  json\n  json --> base\n  scene\n  scene --> json\n```\n");
}

// The architecture is the USES lists of src/CMakeLists.txt. These tests read the same lines and every
// #include.
#include "base/text.h"
#include "structure/source_files.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

namespace fs = std::filesystem;

namespace {

using orbs::structure::TestFolder;

// Large headers stay in the folders that need them: the preprocessed size of each is above 100 000 lines, and
// what the rest of the house sees of the library is our own small header.
using Home = std::pair<std::string_view, std::string_view>;
constexpr std::array kOnlyIn{
    Home{"nlohmann/", "json"}, Home{"tiny_gltf.h", "importer"}, Home{"OpenImageIO/", "image_formats"},
    Home{"OpenEXR/", "image"}, Home{"CLI/", "command_line"},    Home{"embree3/", "tracer"},
    Home{"embree4/", "tracer"}};

struct Rules {
  std::vector<std::string> order;  // modules as listed
  std::map<std::string, std::set<std::string>>
      uses;  // of a module, or of a program's main file as "cli/main.cpp"
};

// The words of the call that starts at `begin`, up to its closing bracket.
std::vector<std::string> call_words(const std::string& text, std::size_t begin) {
  const auto open = text.find('(', begin);
  std::istringstream words(text.substr(open + 1, text.find(')', open) - open - 1));
  std::vector<std::string> result;
  for (std::string word; words >> word;) result.push_back(word);
  return result;
}

Rules read_rules(const fs::path& src) {
  std::string text;
  for (const auto& line : orbs::structure::lines_of(src / "CMakeLists.txt"))
    text += line.substr(0, line.find('#')) + "\n";
  Rules rules;
  for (auto at = text.find("orbs_"); at != std::string::npos; at = text.find("\norbs_", at + 1)) {
    const bool is_program = text.find("orbs_program(", at) == text.find("orbs_", at);
    const auto words = call_words(text, at);
    const std::string& name = words.at(is_program ? 1 : 0);
    if (!is_program) rules.order.push_back(name);
    const auto uses = std::find(words.begin(), words.end(), "USES");
    const auto packages = std::find(words.begin(), words.end(), "PACKAGES");
    rules.uses[name];
    if (uses != words.end()) rules.uses[name].insert(uses + 1, packages);
  }
  return rules;
}

// "metrics/psnr.h" for a line that includes it, "" for any other line.
std::string included_path(const std::string& line) {
  const auto text = orbs::trim(line);
  if (!text.starts_with("#") || !orbs::trim(text.substr(1)).starts_with("include")) return "";
  const auto begin = text.find_first_of("\"<");
  const auto end = text.find_first_of("\">", begin + 1);
  return begin == std::string::npos || end == std::string::npos
             ? ""
             : std::string(text.substr(begin + 1, end - begin - 1));
}

// What is wrong with including `target` in a file of `folder` that may include `uses`; "" when nothing is.
std::string complaint_about(const std::string& target,
                            const std::string& folder,
                            const std::set<std::string>& uses,
                            const Rules& rules) {
  std::vector<std::string> homes;
  for (const auto& [prefix, home] : kOnlyIn)
    if (target.starts_with(prefix)) homes.push_back(fmt::format("src/{}", home));
  if (!homes.empty() && std::find(homes.begin(), homes.end(), "src/" + folder) == homes.end())
    return fmt::format("<{}> may be included only in {}", target, fmt::join(homes, " and "));
  const std::string target_folder = target.substr(0, target.find('/'));
  if (!rules.uses.contains(target_folder) || target_folder == folder || uses.contains(target_folder))
    return "";
  return fmt::format("src/{} may not include \"{}\": its USES list in src/CMakeLists.txt has no {}", folder,
                     target, target_folder);
}

std::vector<std::string> breaches(const fs::path& src) {
  const Rules rules = read_rules(src);
  std::vector<std::string> found;
  for (const auto& file : orbs::structure::files_below(src, {".h", ".cpp", ".inc"})) {
    const fs::path relative = fs::relative(file, src);
    const std::string folder = relative.begin()->string();
    const bool is_program = rules.uses.contains(relative.string());
    if (!rules.uses.contains(folder)) {
      found.push_back(orbs::structure::place(src, file, 1) +
                      "no orbs_module of src/CMakeLists.txt holds this file");
      continue;
    }
    const auto& uses = rules.uses.at(is_program ? relative.string() : folder);
    const auto lines = orbs::structure::lines_of(file);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const std::string complaint = complaint_about(included_path(lines[i]), folder, uses, rules);
      if (!complaint.empty()) found.push_back(orbs::structure::place(src, file, i + 1) + complaint);
    }
  }
  return found;
}

// The folders that the files of a module or a program include, by the name that the USES list stands under.
std::map<std::string, std::set<std::string>> included_folders(const fs::path& src, const Rules& rules) {
  std::map<std::string, std::set<std::string>> included;
  for (const auto& file : orbs::structure::files_below(src, {".h", ".cpp", ".inc"})) {
    const fs::path relative = fs::relative(file, src);
    const bool is_program = rules.uses.contains(relative.string());
    auto& folders = included[is_program ? relative.string() : relative.begin()->string()];
    for (const auto& line : orbs::structure::lines_of(file))
      if (const auto path = included_path(line); path.find('/') != std::string::npos)
        folders.insert(path.substr(0, path.find('/')));
  }
  return included;
}

// A USES entry that no #include needs lets the next breach pass unseen.
std::vector<std::string> unused_edges(const fs::path& src) {
  const Rules rules = read_rules(src);
  auto included = included_folders(src, rules);
  std::vector<std::string> found;
  for (const auto& [name, uses] : rules.uses)
    for (const auto& used : uses)
      if (!included[name].contains(used))
        found.push_back(fmt::format("{} lists {} in its USES and includes nothing of it", name, used));
  return found;
}

// A house of three rooms for showing that a breach is seen.
void write_small_house(const TestFolder& scratch) {
  scratch.write("CMakeLists.txt",
                "orbs_module(base PACKAGES Threads::Threads)\n"
                "orbs_module(json USES base)  # text\n"
                "orbs_module(tracer USES base\n"
                "  PACKAGES embree)\n"
                "orbs_program(p tracer/p_main.cpp USES base json)\n");
  scratch.write("json/read.h", "#include \"base/text.h\"\n#include <nlohmann/json.hpp>\n");
  scratch.write("tracer/p_main.cpp", "#include \"json/read.h\"\n#include \"tracer/trace.h\"\n");
}

}  // namespace

TEST(IncludeRules, FoldersIncludeOnlyWhatTheirUsesListNames) {
  const auto found = breaches(fs::path(ORBS_SOURCE_DIR) / "src");
  EXPECT_TRUE(found.empty()) << orbs::structure::joined(found);
}

TEST(IncludeRules, EveryModuleIsListedAfterTheModulesItUses) {
  const Rules rules = read_rules(fs::path(ORBS_SOURCE_DIR) / "src");
  ASSERT_GE(rules.order.size(), 10u) << "src/CMakeLists.txt is no longer read correctly";
  std::set<std::string> listed;
  for (const auto& module : rules.order) {
    for (const auto& used : rules.uses.at(module))
      EXPECT_TRUE(listed.contains(used))
          << module << " uses " << used << ", which stands below it or nowhere";
    listed.insert(module);
  }
}

TEST(IncludeRules, EveryUsesListNamesOnlyWhatIsIncluded) {
  const auto found = unused_edges(fs::path(ORBS_SOURCE_DIR) / "src");
  EXPECT_TRUE(found.empty()) << orbs::structure::joined(found);
}

TEST(IncludeRules, AnUnusedEdgeIsNamed) {
  const TestFolder scratch("include-rules-unused");
  write_small_house(scratch);
  EXPECT_EQ(orbs::structure::joined(unused_edges(scratch.path())),
            "tracer lists base in its USES and includes nothing of it\n"
            "tracer/p_main.cpp lists base in its USES and includes nothing of it\n");
}

TEST(IncludeRules, AHouseThatKeepsTheRulesHasNoBreach) {
  const TestFolder scratch("include-rules-kept");
  write_small_house(scratch);
  EXPECT_EQ(orbs::structure::joined(breaches(scratch.path())), "");
}

TEST(IncludeRules, EachBreachIsNamedWithFileAndLine) {
  const TestFolder scratch("include-rules-broken");
  write_small_house(scratch);
  scratch.write("base/text.h", "#pragma once\n#include \"json/read.h\"\n");
  scratch.write("tracer/trace.h", "#include <vector>\n#  include <nlohmann/json_fwd.hpp>\n");
  scratch.write("shed/tool.cpp", "");
  EXPECT_EQ(orbs::structure::joined(breaches(scratch.path())),
            "base/text.h:2: src/base may not include \"json/read.h\": its USES list in "
            "src/CMakeLists.txt has no json\n"
            "shed/tool.cpp:1: no orbs_module of src/CMakeLists.txt holds this file\n"
            "tracer/trace.h:2: <nlohmann/json_fwd.hpp> may be included only in src/json\n");
}

// A unit is a header with the source file of its name, or either alone; a header x.h may also speak for the
// files of a folder x/. What a header declares its own unit defines, and units do not include each other in
// a circle.
#include "structure/source_files.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

namespace fs = std::filesystem;

namespace {

using orbs::structure::TestFolder;

// The text without comments, literals and preprocessor lines; each becomes one blank, lines stay lines.
std::string code_of(const fs::path& file) {
  static const std::regex kLiteral(
      R"re(R"(\w*)\([^]*?\)\1"|//.*|/\*[^]*?\*/|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*')re");
  std::string text;
  for (const auto& line : orbs::structure::lines_of(file))
    text += (line.starts_with("#") ? std::string() : line) + "\n";
  return std::regex_replace(text, kLiteral, " ");
}

// A declaration or a definition at namespace scope: its text up to ';' or '{'.
struct Item {
  std::string text;
  bool has_body = false;
};

// What stands at namespace scope, which is inside no braces but those of namespaces.
std::vector<Item> items_of(const std::string& code) {
  static const std::regex kNamespace(R"(^\s*(?:inline\s+)?namespace\b[^;=()]*$)");
  std::vector<Item> items;
  std::string pending;
  int depth = 0;  // of braces that belong to no namespace
  for (const char c : code) {
    if (c == '{') {
      if (depth == 0 && std::regex_match(pending, kNamespace)) {
        pending.clear();
        continue;
      }
      if (depth++ == 0) items.push_back({pending, true});
    } else if (c == '}') {
      if (depth > 0) --depth;
      pending.clear();
    } else if (c == ';' && depth == 0) {
      items.push_back({pending, false});
      pending.clear();
    } else if (depth == 0) {
      pending += c;
    }
  }
  return items;
}

// The name of the free function that the item declares or defines; "" for a template, a variable, a type.
std::string function_name(const std::string& item) {
  static const std::regex kNoFunction(
      R"(^\s*(?:template|using|typedef|struct|class|enum|extern|friend|static_assert|concept|return)\b)");
  static const std::regex kFunction(R"(^[\w\s:<>,&*\[\]]*[\w>&*]\s+[&*]*(\w+)\s*\()");
  if (std::regex_search(item, kNoFunction)) return "";
  std::smatch match;
  if (!std::regex_search(item, match, kFunction)) return "";
  const auto before = item.substr(0, static_cast<std::size_t>(match.position(1)));
  return before.find('=') == std::string::npos ? match[1].str() : "";
}

std::set<std::string> functions_of(const std::string& code, bool with_body) {
  std::set<std::string> names;
  for (const auto& item : items_of(code))
    if (item.has_body == with_body)
      if (auto name = function_name(item.text); !name.empty()) names.insert(std::move(name));
  return names;
}

// CMake writes the source of this header from tables (cmake/embed_table.cmake).
constexpr const char* kGeneratedUnit = "spectra/embedded_tables.h";

std::vector<std::string> misplaced_definitions(const fs::path& src) {
  std::vector<std::string> found;
  for (const auto& header : orbs::structure::files_below(src, {".h"})) {
    if (fs::relative(header, src) == kGeneratedUnit) continue;
    const auto code = code_of(header);
    const auto source = fs::path(header).replace_extension(".cpp");
    const auto folder = fs::path(header).replace_extension();
    auto defined = functions_of(code, true);
    if (fs::exists(source)) defined.merge(functions_of(code_of(source), true));
    if (fs::is_directory(folder))
      for (const auto& file : orbs::structure::files_below(folder, {".cpp"}))
        defined.merge(functions_of(code_of(file), true));
    for (const auto& name : functions_of(code, false))
      if (!defined.contains(name))
        found.push_back(fmt::format("{}declares {}, which {} does not define",
                                    orbs::structure::place(src, header, 1), name,
                                    fs::relative(source, src).string()));
  }
  return found;
}

using Units = std::map<std::string, std::set<std::string>>;  // a unit and those that it includes

Units units_of(const fs::path& src) {
  static const std::regex kInclude(R"re(^\s*#\s*include\s*"([^"]+)\.(?:h|inc)")re");
  Units units;
  for (const auto& file : orbs::structure::files_below(src, {".h", ".cpp", ".inc"})) {
    const auto unit = fs::relative(file, src).replace_extension().string();
    auto& included = units[unit];
    for (const auto& line : orbs::structure::lines_of(file))
      if (std::smatch match; std::regex_search(line, match, kInclude) && match[1] != unit)
        included.insert(match[1]);
  }
  return units;
}

// A unit that can be reached from itself stands in a circle; each circle is told once, by its first unit.
std::vector<std::string> circles(const fs::path& src) {
  const auto units = units_of(src);
  const auto reached_from = [&](const std::string& start) {
    std::set<std::string> reached;
    std::vector<std::string> open{start};
    while (!open.empty()) {
      const auto unit = units.find(open.back());
      open.pop_back();
      if (unit == units.end()) continue;
      for (const auto& next : unit->second)
        if (reached.insert(next).second) open.push_back(next);
    }
    return reached;
  };
  std::map<std::string, std::set<std::string>> reach;
  for (const auto& [name, included] : units) reach[name] = reached_from(name);
  std::set<std::set<std::string>> found;
  for (const auto& [name, reached] : reach) {
    std::set<std::string> circle;
    for (const auto& other : reached)
      if (reach.contains(other) && reach.at(other).contains(name)) circle.insert(other);
    if (!circle.empty()) found.insert(circle);
  }
  std::vector<std::string> texts;
  for (const auto& circle : found) texts.push_back(fmt::format("circle of {}", fmt::join(circle, ", ")));
  return texts;
}

}  // namespace

TEST(Units, WhatAHeaderDeclaresItsOwnSourceFileDefines) {
  const auto found = misplaced_definitions(fs::path(ORBS_SOURCE_DIR) / "src");
  EXPECT_TRUE(found.empty()) << orbs::structure::joined(found);
}

TEST(Units, DoNotIncludeEachOtherInACircle) {
  const auto found = circles(fs::path(ORBS_SOURCE_DIR) / "src");
  EXPECT_TRUE(found.empty()) << orbs::structure::joined(found);
}

TEST(Units, ADefinitionInAnotherFileIsNamed) {
  const TestFolder scratch("units-definitions");
  scratch.write("a/x.h",
                "namespace n {\n"
                "struct S { int member(int); };\n"
                "template <class T> T any(T);\n"
                "inline int here(int a) { return a; }\n"
                "int there(int a = f(1));\n"
                "const std::vector<int>& elsewhere(const S& s);  // int comment(int);\n"
                "constexpr int kNumber = three(1);\n"
                "}  // namespace n\n");
  scratch.write("a/x.cpp", "namespace n {\nint there(int a) { return a; }\n}\n");
  scratch.write("a/y.cpp", "namespace n {\nconst std::vector<int>& elsewhere(const S& s) {}\n}\n");
  EXPECT_EQ(orbs::structure::joined(misplaced_definitions(scratch.path())),
            "a/x.h:1: declares elsewhere, which a/x.cpp does not define\n");
}

TEST(Units, ACircleIsNamedThatPassesThroughASourceFile) {
  const TestFolder scratch("units-circles");
  scratch.write("a/one.h", "#include \"a/three.h\"\n");
  scratch.write("a/one.cpp", "#include \"a/one.h\"\n#include \"a/two.h\"\n");
  scratch.write("a/two.h", "#include \"a/one.h\"\n");
  scratch.write("a/three.h", "");
  EXPECT_EQ(orbs::structure::joined(circles(scratch.path())), "circle of a/one, a/two\n");
}

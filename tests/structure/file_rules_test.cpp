#include "structure/source_files.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace fs = std::filesystem;

namespace {

using orbs::structure::TestFolder;

constexpr std::size_t kMostLines = 500;
const std::set<std::string> kCode{".cpp", ".h",   ".inc", ".py", ".sh",  ".cmake",
                                  ".ts",  ".tsx", ".mjs", ".js", ".css", ".html"};
const std::set<std::string> kText{"",      ".cpp", ".h",   ".inc", ".py",  ".sh",   ".cmake",
                                  ".ts",   ".tsx", ".mjs", ".js",  ".css", ".html", ".md",
                                  ".json", ".txt", ".obj", ".mtl", ".csv", ".ies",  ".pov"};

// Folders of one developer's machine. Written in two halves, so that this file passes its own test.
constexpr std::array<std::string_view, 4> kPrivatePlaces{
    "../sha"
    "red",
    "/wo"
    "rk/",
    "/ro"
    "ot/",
    "/ho"
    "me/"};

std::vector<std::string> long_files(const fs::path& root) {
  std::vector<std::string> found;
  for (const char* folder : {"src", "web", "adapters", "tests", "data/snippets"})
    for (const auto& file : orbs::structure::files_below(root / folder, kCode)) {
      if (file.filename() == "generated.ts") continue;  // the build writes it: nobody reads it whole
      const std::size_t lines = orbs::structure::lines_of(file).size();
      if (lines > kMostLines)
        found.push_back(orbs::structure::place(root, file, lines) +
                        fmt::format("longer than {} lines: split it", kMostLines));
    }
  return found;
}

// An absolute folder counts where a path begins, not in the middle of one.
bool names_place(const std::string& line, std::string_view word) {
  for (auto at = line.find(word); at != std::string::npos; at = line.find(word, at + 1)) {
    const char before = at == 0 ? ' ' : line[at - 1];
    const bool continues_a_path = std::isalnum(static_cast<unsigned char>(before)) ||
                                  std::string_view("._-/}").find(before) != std::string_view::npos;
    if (word.starts_with(".") || !continues_a_path) return true;
  }
  return false;
}

std::vector<std::string> private_places(const fs::path& root) {
  std::vector<std::string> found;
  for (const auto& file : orbs::structure::files_below(root, kText)) {
    const auto lines = orbs::structure::lines_of(file);
    for (std::size_t i = 0; i < lines.size(); ++i)
      for (const auto word : kPrivatePlaces)
        if (names_place(lines[i], word))
          found.push_back(orbs::structure::place(root, file, i + 1) +
                          fmt::format("names {}, which other machines do not have", word));
  }
  return found;
}

}  // namespace

TEST(FileRules, NoSourceFileIsLongerThanFiveHundredLines) {
  const auto found = long_files(ORBS_SOURCE_DIR);
  EXPECT_TRUE(found.empty()) << orbs::structure::joined(found);
}

TEST(FileRules, NoFileNamesAFolderOfOneMachine) {
  const auto found = private_places(ORBS_SOURCE_DIR);
  EXPECT_TRUE(found.empty()) << orbs::structure::joined(found);
}

// Text of strangers reaches the terminal through print_clean alone.
TEST(FileRules, CommandsPrintThroughTheFunctionThatCleans) {
  std::vector<std::string> found;
  for (const auto& file :
       orbs::structure::files_below(fs::path(ORBS_SOURCE_DIR) / "src/cli", {".cpp", ".h"})) {
    const auto lines = orbs::structure::lines_of(file);
    for (std::size_t i = 0; i < lines.size(); ++i)
      for (const char* direct : {"fmt::print(", "std::cout", "std::cerr", "std::printf("})
        if (lines[i].find(direct) != std::string::npos)
          found.push_back(orbs::structure::place(ORBS_SOURCE_DIR, file, i + 1) + "prints past print_clean");
  }
  EXPECT_TRUE(found.empty()) << orbs::structure::joined(found);
}

// fmt has join() in format.h up to version 10, and in ranges.h from 11 on.
TEST(FileRules, WhoJoinsIncludesTheHeaderThatNewFmtHasItIn) {
  const std::string join = std::string("fmt::") + "join(";
  std::vector<std::string> found;
  for (const char* folder : {"src", "tests", "examples", "plugins"})
    for (const auto& file :
         orbs::structure::files_below(fs::path(ORBS_SOURCE_DIR) / folder, {".cpp", ".h"})) {
      bool is_included = false;
      std::size_t use = 0;
      const auto lines = orbs::structure::lines_of(file);
      for (std::size_t i = 0; i < lines.size(); ++i) {
        is_included = is_included || lines[i] == "#include <fmt/ranges.h>";
        if (lines[i].find(join) != std::string::npos) use = i + 1;
      }
      if (use > 0 && !is_included)
        found.push_back(orbs::structure::place(ORBS_SOURCE_DIR, file, use) + "joins without <fmt/ranges.h>");
    }
  EXPECT_TRUE(found.empty()) << orbs::structure::joined(found);
}

TEST(FileRules, AFileOfFiveHundredAndOneLinesIsNamed) {
  const TestFolder scratch("file-rules-long");
  std::string text;
  for (std::size_t i = 0; i < kMostLines; ++i) text += "x\n";
  scratch.write("src/base/fits.h", text);
  scratch.write("adapters/long.py", text + "x\n");
  EXPECT_EQ(orbs::structure::joined(long_files(scratch.path())),
            "adapters/long.py:501: longer than 500 lines: split it\n");
}

TEST(FileRules, APrivatePlaceIsNamedWithFileAndLine) {
  const TestFolder scratch("file-rules-private");
  const std::string place(kPrivatePlaces[1]);
  scratch.write("README.md", "suite" + place + "x is fine\ncd " + place + "x is not\n");
  EXPECT_EQ(orbs::structure::joined(private_places(scratch.path())),
            "README.md:2: names " + place + ", which other machines do not have\n");
}

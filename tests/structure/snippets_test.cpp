// What data/snippets promises: any renderer can take a file of it, and a neighbour where it says so.
#include "base/text.h"
#include "structure/source_files.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace {

using orbs::structure::TestFolder;

// A header of the standard library (no dot and no slash in its name), or a neighbour.
bool is_at_home(std::string_view line, const std::filesystem::path& folder) {
  const auto name = line.substr(line.find_first_of("<\"") + 1);
  const std::string included(name.substr(0, name.find_first_of(">\"")));
  if (line.find('<') != std::string_view::npos) return included.find_first_of("./") == std::string::npos;
  return included.find('/') == std::string::npos && std::filesystem::exists(folder / included);
}

std::vector<std::string> foreign_includes(const std::filesystem::path& folder) {
  std::vector<std::string> found;
  for (const auto& file : orbs::structure::files_below(folder, {".h"})) {
    const auto lines = orbs::structure::lines_of(file);
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (const auto line = orbs::trim(lines[i]); line.starts_with("#include") && !is_at_home(line, folder))
        found.push_back(orbs::structure::place(folder, file, i + 1) + std::string(line));
  }
  return found;
}

}  // namespace

TEST(Snippets, IncludeTheStandardLibraryAndNeighboursOnly) {
  const auto folder = std::filesystem::path(ORBS_SOURCE_DIR) / "data/snippets";
  EXPECT_GE(orbs::structure::files_below(folder, {".h"}).size(), 4u);
  EXPECT_EQ(orbs::structure::joined(foreign_includes(folder)), "");
}

TEST(Snippets, AnyOtherIncludeIsNamed) {
  const TestFolder scratch("snippets");
  scratch.write("b.h", "#pragma once\n");
  scratch.write("a.h",
                "#include <cmath>\n"
                "#include \"b.h\"\n"
                "#include \"c.h\"\n"
                "#include \"base/vec.h\"\n"
                "#include <fmt/format.h>\n"
                "#include <math.h>\n");
  EXPECT_EQ(orbs::structure::joined(foreign_includes(scratch.path())),
            "a.h:3: #include \"c.h\"\n"
            "a.h:4: #include \"base/vec.h\"\n"
            "a.h:5: #include <fmt/format.h>\n"
            "a.h:6: #include <math.h>\n");
}

// What data/snippets promises: any renderer can take one file of it.
#include "base/text.h"
#include "structure/source_files.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace {

using orbs::structure::TestFolder;

// Includes of anything but a header of the standard library, whose names have neither a dot nor a slash.
std::vector<std::string> foreign_includes(const std::filesystem::path& folder) {
  std::vector<std::string> found;
  for (const auto& file : orbs::structure::files_below(folder, {".h"})) {
    const auto lines = orbs::structure::lines_of(file);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const auto line = orbs::trim(lines[i]);
      if (!line.starts_with("#include")) continue;
      if (line.find('"') != std::string_view::npos || line.find_first_of("./") != std::string_view::npos)
        found.push_back(orbs::structure::place(folder, file, i + 1) + std::string(line));
    }
  }
  return found;
}

}  // namespace

TEST(Snippets, IncludeTheStandardLibraryOnly) {
  const auto folder = std::filesystem::path(ORBS_SOURCE_DIR) / "data/snippets";
  EXPECT_GE(orbs::structure::files_below(folder, {".h"}).size(), 4u);
  EXPECT_EQ(orbs::structure::joined(foreign_includes(folder)), "");
}

TEST(Snippets, AnyOtherIncludeIsNamed) {
  const TestFolder scratch("snippets");
  scratch.write("a.h", "#pragma once\n#include <cmath>\n#include \"base/vec.h\"\n#include <fmt/format.h>\n");
  EXPECT_EQ(orbs::structure::joined(foreign_includes(scratch.path())),
            "a.h:3: #include \"base/vec.h\"\na.h:4: #include <fmt/format.h>\n");
}

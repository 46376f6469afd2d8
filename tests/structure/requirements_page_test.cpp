// docs/reference/requirements.md says of each requirement what the case.json files say, and
// docs/reference/known.md of the suites whose answers are known.
#include "registry/cases.h"
#include "registry/configuration.h"
#include "structure/documentation.h"

#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

namespace fs = std::filesystem;

namespace {

using orbs::registry::Case;

constexpr std::size_t kColumns = 100;

std::string entry_of(const Case& one_case, const fs::path& folder) {
  std::vector<std::string> scenes;
  for (const auto& scene : one_case.scenes) scenes.push_back("`" + scene.name + "`");
  for (const auto& difference : one_case.differences)
    scenes.push_back(fmt::format("`{}` (`{}` - `{}`)", difference.name, difference.of, difference.minus));
  const auto wrapped = [](const std::string& text) { return orbs::structure::wrapped(text, kColumns); };
  return fmt::format(
      "### {} {}\n\n{}\n\n{}\n\n{}\n\n", one_case.requirement, one_case.title,
      wrapped("**Tests.** " + one_case.tests), wrapped("**Typical mistake.** " + one_case.typical_mistake),
      wrapped(fmt::format("**Scenes** of [{}]({}): {}.", one_case.name,
                          fs::relative(one_case.file, folder).generic_string(), fmt::join(scenes, ", "))));
}

std::string entries_of(const orbs::registry::Suite& suite, const fs::path& folder) {
  std::string out = "\n";
  for (const auto& one_case : orbs::registry::load_cases(suite)) out += entry_of(one_case, folder);
  return out;
}

// Each requirement has one entry on the page of the requirements.
const char* page_of(const std::string& suite) {
  return suite == "known" || suite == "gi" || suite == "stability" ? "docs/reference/known.md"
                                                                   : "docs/reference/requirements.md";
}

}  // namespace

TEST(RequirementsPage, SaysWhatTheCasesSay) {
  const fs::path root = ORBS_SOURCE_DIR;
  const auto configuration = orbs::registry::load_configuration(root / "configuration.json");
  ASSERT_GE(configuration.suites.size(), 3U);
  for (const auto& suite : configuration.suites)
    EXPECT_EQ(orbs::structure::check_generated_part(root / page_of(suite.name), "cases of " + suite.name,
                                                    entries_of(suite, root / "docs/reference")),
              "");
}

TEST(RequirementsPage, HasAnEntryForEachRequirement) {
  const auto page = orbs::structure::read_page(fs::path(ORBS_SOURCE_DIR) / "docs/reference/requirements.md");
  for (const char* heading :
       {"G1", "G5", "M1", "M8", "L1", "L4", "A1", "A4", "E1", "E6", "S1", "S7", "T1", "T3",
        "B1", "B9", "C1", "C5", "D1", "D6", "N1", "N2", "N3", "N4", "N5", "N6", "I1", "I2"}) {
    int found = 0;
    for (const auto& line : page.lines) found += line.starts_with(fmt::format("### {} ", heading)) ? 1 : 0;
    EXPECT_GE(found, 1) << heading;
  }
}

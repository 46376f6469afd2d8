// The pages of the documentation: their links lead somewhere, and the README stays short.
#include "structure/documentation.h"

#include "structure/source_files.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace fs = std::filesystem;

namespace {

using orbs::structure::joined;
using orbs::structure::Link;
using orbs::structure::Page;
using orbs::structure::TestFolder;

constexpr std::size_t kMostReadmeLines = 120;
constexpr std::size_t kMostReadmeColumns = 100;

// Addresses of the web are not asked: a test must not need a network.
bool is_of_the_web(const std::string& target) {
  return target.find("://") != std::string::npos || target.starts_with("mailto:");
}

// What is wrong with a link; "" when nothing is.
std::string complaint_about(const Page& page, const Link& link) {
  if (is_of_the_web(link.target)) return "";
  const auto hash = link.target.find('#');
  const auto path = link.target.substr(0, hash);
  const auto file = path.empty() ? page.file : page.file.parent_path() / path;
  if (!fs::exists(file)) return fmt::format("there is no {}", path);
  if (hash == std::string::npos || file.extension() != ".md") return "";
  const auto anchor = link.target.substr(hash + 1);
  const auto known = path.empty() ? page.anchors : orbs::structure::read_page(file).anchors;
  return known.contains(anchor) ? "" : fmt::format("no heading has the anchor #{}", anchor);
}

std::vector<std::string> broken_links(const fs::path& root) {
  std::vector<std::string> found;
  for (const auto& page : orbs::structure::pages_below(root))
    for (const auto& link : page.links)
      if (const auto complaint = complaint_about(page, link); !complaint.empty())
        found.push_back(orbs::structure::place(root, page.file, link.line) +
                        fmt::format("the link ({}) leads nowhere: {}", link.target, complaint));
  return found;
}

// Characters, not bytes: continuation bytes of UTF-8 do not count.
std::size_t columns_of(const std::string& line) {
  return static_cast<std::size_t>(std::count_if(
      line.begin(), line.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; }));
}

std::vector<std::string> readme_complaints(const fs::path& root) {
  const auto file = root / "README.md";
  const auto lines = orbs::structure::lines_of(file);
  std::vector<std::string> found;
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (columns_of(lines[i]) > kMostReadmeColumns)
      found.push_back(orbs::structure::place(root, file, i + 1) +
                      fmt::format("longer than {} columns", kMostReadmeColumns));
  if (lines.size() > kMostReadmeLines)
    found.push_back(
        orbs::structure::place(root, file, lines.size()) +
        fmt::format("longer than {} lines: what is not for newcomers belongs into docs/", kMostReadmeLines));
  return found;
}

// All that follows such a block is shown as code, links and headings too.
std::vector<std::string> open_blocks(const fs::path& root) {
  std::vector<std::string> found;
  for (const auto& page : orbs::structure::pages_below(root))
    if (page.open_block > 0)
      found.push_back(orbs::structure::place(root, page.file, page.open_block) +
                      "this block of code is not closed, or an earlier one was not");
  return found;
}

// Pages of docs/ that no page links to.
std::vector<std::string> unreachable_pages(const fs::path& root) {
  std::set<fs::path> linked;
  for (const auto& page : orbs::structure::pages_below(root))
    for (const auto& link : page.links)
      if (!is_of_the_web(link.target))
        linked.insert(
            (page.file.parent_path() / link.target.substr(0, link.target.find('#'))).lexically_normal());
  std::vector<std::string> found;
  for (const auto& page : orbs::structure::pages_below(root / "docs"))
    if (!linked.contains(page.file.lexically_normal()))
      found.push_back(orbs::structure::place(root, page.file, 1) + "no page links to this one");
  return found;
}

}  // namespace

TEST(Documentation, EveryRelativeLinkLeadsSomewhere) {
  const auto found = broken_links(ORBS_SOURCE_DIR);
  EXPECT_TRUE(found.empty()) << joined(found);
}

TEST(Documentation, EveryBlockOfCodeIsClosed) {
  const auto found = open_blocks(ORBS_SOURCE_DIR);
  EXPECT_TRUE(found.empty()) << joined(found);
}

TEST(Documentation, AnOpenBlockOfCodeIsNamed) {
  const TestFolder scratch("documentation-blocks");
  scratch.write("README.md", "# One\n```sh\nx\n\n## Two\n```sh\ny\n```\n");
  EXPECT_EQ(joined(open_blocks(scratch.path())),
            "README.md:8: this block of code is not closed, or an earlier one was not\n");
}

TEST(Documentation, EveryPageIsLinked) {
  const auto found = unreachable_pages(ORBS_SOURCE_DIR);
  EXPECT_TRUE(found.empty()) << joined(found);
}

TEST(Documentation, TheReadmeIsShort) {
  const auto found = readme_complaints(ORBS_SOURCE_DIR);
  EXPECT_TRUE(found.empty()) << joined(found);
}

TEST(Documentation, ALinkToNothingIsNamedWithFileAndLine) {
  const TestFolder scratch("documentation-links");
  scratch.write("README.md",
                "# One, `two`\n[a](#one-two) [b](docs/a.md#there)\n\n![c](no.png) `[d](no)` "
                "[e](docs/a.md#gone)\n[f](https://example.org/x)\n");
  scratch.write("docs/a.md", "# There\n```\n# gone\n[g](no.md)\n```\n");
  EXPECT_EQ(joined(broken_links(scratch.path())),
            "README.md:4: the link (no.png) leads nowhere: there is no no.png\n"
            "README.md:4: the link (docs/a.md#gone) leads nowhere: no heading has the anchor #gone\n");
}

TEST(Documentation, APageThatNobodyLinksIsNamed) {
  const TestFolder scratch("documentation-pages");
  scratch.write("README.md", "[a](docs/a.md#x)\n");
  scratch.write("docs/a.md", "# X\n");
  scratch.write("docs/b.md", "# Y\n");
  EXPECT_EQ(joined(unreachable_pages(scratch.path())), "docs/b.md:1: no page links to this one\n");
}

TEST(Documentation, AReadmeThatIsTooLongIsNamed) {
  const TestFolder scratch("documentation-readme");
  std::string text;
  for (std::size_t i = 0; i < kMostReadmeLines; ++i) text += "x\n";
  scratch.write("README.md", text + std::string(kMostReadmeColumns, 'x') + "\xc3\xa4\n");
  EXPECT_EQ(joined(readme_complaints(scratch.path())),
            "README.md:121: longer than 100 columns\n"
            "README.md:121: longer than 120 lines: what is not for newcomers belongs into docs/\n");
}

#pragma once

#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

/// The Markdown pages of the project, as far as the tests of the documentation need to read them.
namespace orbs::structure {

/// One line of a ``` block: its text and where it stands. `language` is what follows the opening ```.
struct CodeLine {
  std::size_t number = 0;  // from 1
  std::string language;
  std::string text;
};

struct Link {
  std::size_t line = 0;  // from 1
  std::string target;    // "docs/use/cases.md#gates"; images count as links
};

/// What a page holds. Lines of code blocks are no headings, and have no links.
struct Page {
  std::filesystem::path file;
  std::vector<std::string> lines;
  std::vector<Link> links;
  std::vector<CodeLine> code;
  std::set<std::string> anchors;  // of its headings, as GitHub makes them
  std::size_t open_block = 0;     // line of a block of code that nothing closes; 0 if there is none
};

Page read_page(const std::filesystem::path& file);

/// All *.md below `root`, sorted; no builds, outputs or hidden folders.
std::vector<Page> pages_below(const std::filesystem::path& root);

/// "A case, and `case.json`" becomes "a-case-and-casejson": lower case, punctuation dropped, spaces as
/// hyphens.
std::string anchor_of(const std::string& heading);

/// The lines from the heading `heading` ("## orbs run") to the next one of its level or above; empty when
/// there is none.
std::vector<std::string> section(const Page& page, const std::string& heading);

/// Compares the part of a page between the lines "<!-- generated: name -->" and "<!-- end of name -->" with
/// what it must hold. With ORBS_WRITE_DOCUMENTATION in the
/// environment it writes the part instead. Returns the complaint, "" when all is well.
std::string check_generated_part(const std::filesystem::path& file,
                                 const std::string& name,
                                 const std::string& expected);

/// The paragraph in lines of at most `width` bytes.
std::string wrapped(const std::string& text, std::size_t width);

}  // namespace orbs::structure

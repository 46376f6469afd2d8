#pragma once

#include <string>
#include <vector>

/// The command lines of orbs that the pages of the project show, in blocks of code and within sentences.
namespace orbs::cli_tests {

struct ShownCommand {
  std::string place;  // "docs/use/cases.md:12: "
  std::string line;   // "orbs run -s 101", with all lines that a \ joins
  bool is_of_block = true;
};

/// All of them. `orbs …` in a sentence counts as well; what holds a "…" shows only a part and is left out.
std::vector<ShownCommand> shown_commands();

/// The words of a line as a shell sees them: quotes are taken off, and the words end where a comment, a pipe,
/// a redirection or another command begins.
std::vector<std::string> shell_words(const std::string& line);

}  // namespace orbs::cli_tests

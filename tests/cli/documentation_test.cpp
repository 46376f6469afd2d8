// What the documentation says about the program: docs/reference/commands.md names every option that --help
// names, and the commands that the pages show work.
#include "structure/documentation.h"

#include "base/text.h"
#include "cli/program.h"
#include "cli/sandbox.h"
#include "cli/shown_commands.h"

#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

namespace fs = std::filesystem;
using namespace orbs;
using cli_tests::Sandbox;

namespace {

const fs::path kRoot = ORBS_SOURCE_DIR;

std::set<std::string> options_in(const std::string& text) {
  static const std::regex option(R"((^|[^A-Za-z0-9-])(--[a-z][a-z-]*))");
  std::set<std::string> found;
  for (auto at = std::sregex_iterator(text.begin(), text.end(), option); at != std::sregex_iterator(); ++at)
    found.insert((*at)[2].str());
  return found;
}

// Options that the help lists, from the first column of its table. Words in descriptions do not count.
std::set<std::string> listed_options(const std::string& help) {
  static const std::regex row(R"(^  ((-[A-Za-z],)?--[a-z].*))");
  std::set<std::string> found;
  for (const auto& line : split(help, '\n')) {
    std::smatch match;
    if (!std::regex_search(line, match, row)) continue;
    const auto names = match[1].str();
    for (const auto& option : options_in(names.substr(0, names.find(' ')))) found.insert(option);
  }
  return found;
}

// "orbs run" and its like, and "orbs renderer add": the commands by their words, with their help.
std::map<std::string, std::string> help_of_commands(const Sandbox& sandbox) {
  static const std::regex command(R"(^  ([a-z][a-z-]*) {2,}\S)");
  const auto subcommands = [](const std::string& help) {
    std::vector<std::string> names;
    // The last group shows example lines that begin with "orbs".
    for (const auto& line : split(help, '\n')) {
      std::smatch match;
      if (std::regex_search(line, match, command) && match[1] != "orbs") names.push_back(match[1]);
    }
    return names;
  };
  std::map<std::string, std::string> help;
  for (const auto& name : subcommands(sandbox.orbs({"--help"}).text)) {
    const auto text = sandbox.orbs({name, "--help"}).text;
    const auto below = subcommands(text);
    if (below.empty()) help["orbs " + name] = text;
    for (const auto& second : below)
      help["orbs " + name + " " + second] = sandbox.orbs({name, second, "--help"}).text;
  }
  return help;
}

// As Markdown shows them: not as the letters of a table, of HTML or of emphasis.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char letter : text) {
    if (letter == '|' || letter == '<' || letter == '*') out += '\\';
    out += letter == '\n' ? ' ' : letter;
  }
  return out;
}

std::string option_table(const command_line::Command& command) {
  std::string rows;
  for (const auto& option : command.options()) {
    std::vector<std::string> names;
    for (const auto& name : option.short_names) names.push_back("`-" + name + "`");
    for (const auto& name : option.long_names) names.push_back("`--" + name + "`");
    if (names.empty()) names.push_back("`" + option.name + "`");
    if (names.back() != "`--help`")  // every command has it; the page says so once
      rows += fmt::format("| {} | {} |\n", fmt::join(names, ", "), escaped(option.description));
  }
  return rows.empty() ? "" : "| option | |\n|---|---|\n" + rows;
}

// Each command, or the commands below it, as "orbs renderer add".
std::vector<std::pair<std::string, command_line::Command>> all_commands(const command_line::Command& all) {
  std::vector<std::pair<std::string, command_line::Command>> out;
  for (const auto& command : all.commands()) {
    const auto below = command.commands();
    if (below.empty()) out.emplace_back("orbs " + command.name(), command);
    for (const auto& second : below)
      out.emplace_back(fmt::format("orbs {} {}", command.name(), second.name()), second);
  }
  return out;
}

// What the program says of a command line that it does not read; "" of one that it does. A sentence may name
// options without their values and a command without what it needs: then only names are looked at.
std::string complaint_about(const std::string& line, bool is_whole) {
  const cli::Program program{"", ORBS_BINARY_DIR, {}};
  const command_line::Program parser("orbs", "", "");
  cli::Action action;
  const auto all = parser.command();
  cli::add_commands(all, program, action);
  auto words = cli_tests::shell_words(line);
  std::vector<char*> arguments;
  arguments.reserve(words.size());
  for (auto& word : words) arguments.push_back(word.data());
  const auto parsed = parser.parse(static_cast<int>(arguments.size()), arguments.data());
  if (parsed.problem.empty()) return {};
  const auto complaint = cli::parse_complaint(parsed, all);
  const bool lacks_something = complaint.find("needs a value") != std::string::npos ||
                               complaint.find("is required") != std::string::npos ||
                               complaint.find("needs a command") != std::string::npos;
  return !is_whole && lacks_something ? "" : complaint;
}

bool is_cheap(const std::string& line) {
  return line.find(" --help") != std::string::npos || line.starts_with("orbs list") ||
         line.starts_with("orbs doctor") || line.starts_with("orbs effects");
}

}  // namespace

TEST(Help, NamesOptionsAsTheyAreTyped) {
  const Sandbox sandbox;
  const auto help = help_of_commands(sandbox);
  ASSERT_GE(help.size(), 10u) << "the help is no longer read correctly";
  for (const auto& [command, text] : help)
    EXPECT_EQ(text.find("{false}"), std::string::npos) << command << '\n' << text;
}

TEST(CommandsPage, NamesEveryCommandAndOptionAndNoOther) {
  const Sandbox sandbox;
  const auto help = help_of_commands(sandbox);
  ASSERT_GE(help.size(), 10u) << "the help is no longer read correctly";
  const auto page = structure::read_page(kRoot / "docs/reference/commands.md");
  for (const auto& [name, text] : help) {
    std::string section;
    // What follows " -- " is the command of a renderer.
    for (const auto& line : structure::section(page, "## " + name))
      section += line.substr(0, line.find(" -- ")) + "\n";
    EXPECT_FALSE(section.empty()) << "docs/reference/commands.md has no section '## " << name << "'";
    auto listed = listed_options(text);
    auto named = options_in(section);
    listed.erase("--help");  // every command has it; the page says so once
    for (const auto& option : listed)
      EXPECT_TRUE(named.contains(option)) << "the section '" << name << "' does not name " << option;
    for (const auto& option : named)
      EXPECT_TRUE(listed.contains(option)) << name << " has no " << option << ", which its section names";
  }
  for (const auto& line : page.lines)
    EXPECT_TRUE(!line.starts_with("## orbs ") || help.contains(line.substr(3))) << line;
}

TEST(CommandsPage, SaysOfEachOptionWhatTheHelpSays) {
  const cli::Program program{"", ORBS_BINARY_DIR, {}};
  const command_line::Program parser("orbs", "", "");
  cli::Action action;
  const auto all = parser.command();
  cli::add_commands(all, program, action);
  const auto page = kRoot / "docs/reference/commands.md";
  std::string list = "| command | |\n|---|---|\n";
  for (const auto& [name, command] : all_commands(all)) {
    list += fmt::format("| [`{}`](#{}) | {} |\n", name, structure::anchor_of(name),
                        escaped(command.description()));
    EXPECT_EQ(structure::check_generated_part(page, "options of " + name, option_table(command)), "");
  }
  EXPECT_EQ(structure::check_generated_part(page, "commands", list), "");
}

// The parser is that of the program, so that an option which is not there, one that is refused, a value out
// of its range and a word in the wrong place are all found. Nothing is done.
TEST(ShownCommands, AreReadByTheProgram) {
  const auto shown = cli_tests::shown_commands();
  ASSERT_GE(shown.size(), 250u) << "the pages are no longer read correctly";
  for (const auto& [place, line, is_of_block] : shown)
    EXPECT_EQ(complaint_about(line, is_of_block), "") << place << line;
}

TEST(ShownCommands, ThatAreCheapSucceed) {
  const Sandbox sandbox;
  int tried = 0;
  for (const auto& [place, line, is_of_block] : cli_tests::shown_commands()) {
    if (!is_of_block || !is_cheap(line)) continue;
    const auto answer = sandbox.shell(fmt::format("cd '{}' && '{}/{}", kRoot.string(), ORBS_BINARY_DIR,
                                                  "orbs'" + line.substr(std::string("orbs").size())));
    EXPECT_EQ(answer.status, 0) << place << line << "\n" << answer.text;
    ++tried;
  }
  EXPECT_GE(tried, 4) << "the pages are no longer read correctly";
}

TEST(ShownCommands, AreSplitAsAShellDoes) {
  using Words = std::vector<std::string>;
  EXPECT_EQ(cli_tests::shell_words("orbs run -c 'm*' \"a b\" x\\ y # all"),
            (Words{"orbs", "run", "-c", "m*", "a b", "x y"}));
  EXPECT_EQ(cli_tests::shell_words("orbs list --json | jq ."), (Words{"orbs", "list", "--json"}));
}

// What the documentation says about the program: docs/reference/commands.md names every option that --help
// names, and the commands that the pages show work.
#include "structure/documentation.h"

#include "base/text.h"
#include "cli/program.h"
#include "cli/sandbox.h"

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

// The command that a line of the shell calls, "" when it is none of ours: longest name first, since "orbs
// renderer add" begins like others.
std::string command_in(const std::string& line, const std::map<std::string, std::string>& help) {
  std::string found;
  for (const auto& [name, text] : help)
    if ((line + " ").starts_with(name + " ") && name.size() > found.size()) found = name;
  return found;
}

// A line without its comment, and with "orbs" for the path of the program.
std::string shell_line(const std::string& text) {
  auto line = std::string(trim(text.substr(0, text.find("  #"))));
  if (line.starts_with("build/release/orbs ")) line = line.substr(std::string("build/release/").size());
  return line;
}

struct ShownCommand {
  std::string place;
  std::string line;
};

std::vector<ShownCommand> shown_commands() {
  std::vector<ShownCommand> out;
  for (const auto& page : structure::pages_below(kRoot))
    for (const auto& code : page.code)
      if (const auto line = shell_line(code.text); code.language == "sh" && line.starts_with("orbs "))
        out.push_back({fmt::format("{}:{}: ", fs::relative(page.file, kRoot).string(), code.number), line});
  return out;
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

TEST(ShownCommands, HaveOptionsThatTheProgramHas) {
  const Sandbox sandbox;
  const auto help = help_of_commands(sandbox);
  const auto shown = shown_commands();
  ASSERT_GE(shown.size(), 10u) << "the pages are no longer read correctly";
  for (const auto& [place, line] : shown) {
    const auto command = command_in(line, help);
    if (command.empty()) {
      EXPECT_TRUE(line == "orbs --help" || line == "orbs --version") << place << line;
      continue;
    }
    const auto listed = listed_options(help.at(command));
    for (const auto& option : options_in(line.substr(0, line.find(" -- "))))
      EXPECT_TRUE(listed.contains(option)) << place << command << " has no " << option;
  }
}

TEST(ShownCommands, ThatAreCheapSucceed) {
  const Sandbox sandbox;
  int tried = 0;
  for (const auto& [place, line] : shown_commands()) {
    if (!is_cheap(line)) continue;
    const auto answer = sandbox.shell(fmt::format("cd '{}' && '{}/{}", kRoot.string(), ORBS_BINARY_DIR,
                                                  "orbs'" + line.substr(std::string("orbs").size())));
    EXPECT_EQ(answer.status, 0) << place << line << "\n" << answer.text;
    ++tried;
  }
  EXPECT_GE(tried, 4) << "the pages are no longer read correctly";
}

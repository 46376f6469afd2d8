#include "base/terminal.h"
#include "base/text.h"
#include "cli/program.h"

#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::cli {

namespace {

// Commands with "renderer add" as "renderer": what follows their first word.
struct Completed {
  std::string name;
  std::string summary;
  std::vector<command_line::OptionText> options;
  std::vector<std::string> words;  // of its own commands, or that its argument may be
};

Completed completed(const command_line::Command& command) {
  Completed found{command.name(), command.description(), {}, {}};
  const auto add_options = [&](const command_line::Command& of) {
    for (const auto& option : of.options())
      if (!option.long_names.empty()) found.options.push_back(option);
  };
  add_options(command);
  for (const auto& below : command.commands()) {
    found.words.push_back(below.name());
    add_options(below);
  }
  if (found.name == "list") found.words = {"all", "suites", "renderers", "requirements", "cases", "scenes"};
  if (found.name == "completion") found.words = {"bash", "zsh", "fish"};
  return found;
}

std::vector<std::string> option_words(const Completed& command) {
  std::vector<std::string> words;
  for (const auto& option : command.options)
    for (const auto& name : option.long_names) words.push_back("--" + name);
  return words;
}

// Files complete where nothing else does.
std::string bash_script(const std::vector<Completed>& commands) {
  std::vector<std::string> names;
  std::string cases;
  for (const auto& command : commands) {
    names.push_back(command.name);
    cases += fmt::format("    {}) options='{}' words='{}' ;;\n", command.name,
                         fmt::join(option_words(command), " "), fmt::join(command.words, " "));
  }
  return fmt::format(
      "_orbs() {{\n"
      "  local current=${{COMP_WORDS[COMP_CWORD]}} options='--help --version' words='{}'\n"
      "  if ((COMP_CWORD > 1)); then case ${{COMP_WORDS[1]}} in\n"
      "{}    *) options= words= ;;\n"
      "  esac; fi\n"
      "  if [[ $current == -* ]]; then words=$options; fi\n"
      "  COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n"
      "}}\n"
      "complete -o default -F _orbs orbs\n",
      fmt::join(names, " "), cases);
}

// A text between apostrophes of fish.
std::string quoted(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\'' || c == '\\') out += '\\';
    out += c;
  }
  return "'" + out + "'";
}

std::string fish_script(const std::vector<Completed>& commands) {
  std::string text;
  for (const auto& command : commands) {
    text += fmt::format("complete -c orbs -n __fish_use_subcommand -a {} -d {}\n", command.name,
                        quoted(command.summary));
    const auto here = fmt::format("complete -c orbs -n '__fish_seen_subcommand_from {}'", command.name);
    if (!command.words.empty()) text += fmt::format("{} -a '{}'\n", here, fmt::join(command.words, " "));
    for (const auto& option : command.options) {
      std::string names;
      for (const auto& name : option.short_names) names += " -s " + name;
      for (const auto& name : option.long_names) names += " -l " + name;
      text += fmt::format("{}{} -d {}\n", here, names, quoted(clean_line(option.description)));
    }
  }
  return text;
}

}  // namespace

void add_completion_command(const command_line::Command& command,
                            const Program& /*program*/,
                            Action& action) {
  const auto shell = std::make_shared<std::string>();
  command.add_option("shell", *shell, "bash, zsh or fish").required().one_of({"bash", "zsh", "fish"});
  command.callback([=, &action] {
    action = [=] {
      std::vector<Completed> commands;
      for (const auto& one : command.parent().commands()) commands.push_back(completed(one));
      if (*shell == "fish") {
        print_raw(stdout, fish_script(commands));
      } else {
        // zsh reads the script of bash.
        if (*shell == "zsh")
          print_raw(stdout, "#compdef orbs\nautoload -U +X bashcompinit && bashcompinit\n");
        print_raw(stdout, bash_script(commands));
      }
      return 0;
    };
  });
}

}  // namespace orbs::cli

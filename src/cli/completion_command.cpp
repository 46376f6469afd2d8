#include "base/error.h"
#include "base/terminal.h"
#include "base/text.h"
#include "cli/complete_values.h"
#include "cli/program.h"

#include <map>
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

// "    run:-s|run:--scene) kind=scenes ;;": what the word before the one at the cursor asks for.
std::string value_cases(const std::vector<Completed>& commands) {
  std::map<std::string, std::vector<std::string>> options;  // by kind
  for (const auto& command : commands)
    for (const auto& option : command.options) {
      const auto kind = value_kind(option);
      if (kind.empty()) continue;
      for (const auto& name : option.short_names) options[kind].push_back(command.name + ":-" + name);
      for (const auto& name : option.long_names) options[kind].push_back(command.name + ":--" + name);
    }
  std::string cases;
  for (const auto& [kind, names] : options)
    cases += fmt::format("    {}) kind={} ;;\n", fmt::join(names, "|"), kind);
  return cases;
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
      "  local current=${{COMP_WORDS[COMP_CWORD]}} options='--help --version' words='{}' kind=\n"
      "  if ((COMP_CWORD > 1)); then case ${{COMP_WORDS[1]}} in\n"
      "{}    *) options= words= ;;\n"
      "  esac; fi\n"
      "  if ((COMP_CWORD > 2)); then case ${{COMP_WORDS[1]}}:${{COMP_WORDS[COMP_CWORD-1]}} in\n"
      "{}  esac; fi\n"
      "  if [[ $current == -* ]]; then words=$options\n"
      "  elif [[ $kind ]]; then words=$(\"${{COMP_WORDS[0]}}\" completion --values \"$kind\" 2>/dev/null); fi\n"
      "  COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n"
      "}}\n"
      "complete -o default -F _orbs orbs\n",
      fmt::join(names, " "), cases, value_cases(commands));
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
      // -x: its value is no file.
      const auto kind = value_kind(option);
      const auto values = kind.empty() ? "" : fmt::format(" -x -a '(orbs completion --values {})'", kind);
      text += fmt::format("{}{}{} -d {}\n", here, names, values, quoted(clean_line(option.description)));
    }
  }
  return text;
}

}  // namespace

void add_completion_command(const command_line::Command& command, const Program& program, Action& action) {
  const auto shell = std::make_shared<std::string>();
  const auto kind = std::make_shared<std::string>();
  command.add_option("shell", *shell, "bash, zsh or fish").one_of({"bash", "zsh", "fish"});
  command
      .add_option("--values", *kind,
                  "Print the values of this kind instead, one a line: what the scripts offer")
      .one_of(value_kinds());
  command.callback([=, &program, &action] {
    action = [=, &program] {
      if (shell->empty() == kind->empty())
        throw InputError("'orbs completion' needs a shell: bash, zsh or fish; or --values");
      if (!kind->empty()) {
        for (const auto& value : values_of_kind(*kind, program)) print_clean("{}\n", value);
        return 0;
      }
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

#include "base/terminal.h"
#include "base/text.h"
#include "cli/command_table.h"

#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace orbs::cli {

namespace {

// Text for troff: a backslash begins an escape, a hyphen of an option is no soft one, and a line must not
// begin with a control character (groff(7)).
std::string roff(const std::string& text) {
  std::string out;
  for (const char c : clean_text(text)) {
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else if ((c == '.' || c == '\'') && (out.empty() || out.back() == '\n'))
      out += std::string("\\&") + c;
    else
      out += c;
  }
  return out;
}

std::string option_lines(const CLI::App& command) {
  std::string text;
  for (const auto* option : command.get_options()) {
    std::string names;
    for (const auto& name : option->get_snames()) names += (names.empty() ? "-" : ", -") + name;
    for (const auto& name : option->get_lnames()) names += (names.empty() ? "--" : ", --") + name;
    if (names.empty()) names = option->get_name(true);
    text += fmt::format(".TP\n.B {}\n{}\n", roff(names), roff(option->get_description()));
  }
  return text;
}

std::string command_section(const CLI::App& command, const std::string& name) {
  auto text = fmt::format(".SS {}\n{}\n", roff(name), roff(command.get_description()));
  text += option_lines(command);
  if (!command.get_footer().empty()) text += fmt::format(".PP\n{}\n", roff(command.get_footer()));
  for (const auto* below : command.get_subcommands({}))
    text += command_section(*below, name + " " + below->get_name());
  return text;
}

std::string manual(const CLI::App& app, const std::string& version) {
  auto text = fmt::format(
      ".TH ORBS 1 \"\" \"orbs {}\"\n.SH NAME\norbs \\- benchmark of renderers\n.SH SYNOPSIS\n.B orbs\n"
      "COMMAND [OPTIONS]\n.SH DESCRIPTION\n{}\n.SH COMMANDS\n",
      roff(version), roff(app.get_description()));
  for (const auto* command : app.get_subcommands({})) text += command_section(*command, command->get_name());
  return text;
}

}  // namespace

void add_manual_command(CLI::App& command, const Program& program, Action& action) {
  const auto* own = &command;
  command.callback([=, &program, &action] {
    action = [=, &program] {
      print_raw(stdout, manual(*own->get_parent(), program.version));
      return 0;
    };
  });
}

}  // namespace orbs::cli

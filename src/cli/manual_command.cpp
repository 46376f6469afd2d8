#include "base/terminal.h"
#include "base/text.h"
#include "cli/program.h"

#include <string>

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

std::string option_lines(const command_line::Command& command) {
  std::string text;
  for (const auto& option : command.options()) {
    std::string names;
    for (const auto& name : option.short_names) names += (names.empty() ? "-" : ", -") + name;
    for (const auto& name : option.long_names) names += (names.empty() ? "--" : ", --") + name;
    if (names.empty()) names = option.name;
    text += fmt::format(".TP\n.B {}\n{}\n", roff(names), roff(option.description));
  }
  return text;
}

std::string command_section(const command_line::Command& command, const std::string& name) {
  auto text = fmt::format(".SS {}\n{}\n", roff(name), roff(command.description()));
  text += option_lines(command);
  if (!command.footer().empty()) text += fmt::format(".PP\n{}\n", roff(command.footer()));
  for (const auto& below : command.commands()) text += command_section(below, name + " " + below.name());
  return text;
}

std::string manual(const command_line::Command& app, const std::string& version) {
  auto text = fmt::format(
      ".TH ORBS 1 \"\" \"orbs {}\"\n.SH NAME\norbs \\- benchmark of renderers\n.SH SYNOPSIS\n.B orbs\n"
      "COMMAND [OPTIONS]\n.SH DESCRIPTION\n{}\n.SH COMMANDS\n",
      roff(version), roff(app.description()));
  for (const auto& command : app.commands()) text += command_section(command, command.name());
  return text;
}

}  // namespace

void add_manual_command(const command_line::Command& command, const Program& program, Action& action) {
  command.callback([=, &program, &action] {
    action = [=, &program] {
      print_raw(stdout, manual(command.parent(), program.version));
      return 0;
    };
  });
}

}  // namespace orbs::cli

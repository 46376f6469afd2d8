#include "command_line/manual.h"

#include "base/text.h"

#include <fmt/format.h>

namespace orbs::command_line {

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

std::string option_lines(const Command& command) {
  std::string text;
  for (const auto& option : command.options()) {
    std::string names;
    for (const auto& name : option.short_names) names += (names.empty() ? "-" : ", -") + name;
    for (const auto& name : option.long_names) names += (names.empty() ? "--" : ", --") + name;
    if (names.empty()) names = option.name;
    text += fmt::format(".TP\n.B {}\n", roff(names));
    // The argument in italics, on the same line.
    if (!option.value.empty() && option.value != names)
      text.insert(text.size() - 1, fmt::format(" \\fI{}\\fR", roff(option.value)));
    text += roff(option.description) + "\n";
  }
  return text;
}

std::string command_section(const Command& command, const std::string& name) {
  auto text = fmt::format(".SS {}\n{}\n", roff(name), roff(command.description()));
  text += option_lines(command);
  if (!command.footer().empty()) text += fmt::format(".PP\n{}\n", roff(command.footer()));
  for (const auto& below : command.commands()) text += command_section(below, name + " " + below.name());
  return text;
}

}  // namespace

std::string manual_page(const Command& program,
                        const std::string& name,
                        const std::string& summary,
                        const std::string& version) {
  std::string upper = name;
  for (char& letter : upper)
    if (letter >= 'a' && letter <= 'z') letter = static_cast<char>(letter - 'a' + 'A');
  const auto commands = program.commands();
  auto text = fmt::format(
      ".TH {} 1 \"\" \"{} {}\"\n.SH NAME\n{} \\- {}\n.SH SYNOPSIS\n.B {}\n{}\n.SH DESCRIPTION\n{}\n",
      roff(upper), roff(name), roff(version), roff(name), roff(summary), roff(name),
      commands.empty() ? "[OPTIONS] SCENE" : "COMMAND [OPTIONS]", roff(program.description()));
  if (commands.empty()) return text + ".SH OPTIONS\n" + option_lines(program);
  text += ".SH COMMANDS\n";
  for (const auto& command : commands) text += command_section(command, command.name());
  return text;
}

}  // namespace orbs::command_line

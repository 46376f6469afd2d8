#include "cli/parse_complaint.h"

#include "base/text.h"

#include <algorithm>
#include <set>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::cli {

namespace {

// The innermost command that was given, and its words: "renderer add".
std::pair<command_line::Command, std::string> chosen_command(command_line::Command command) {
  std::string words;
  for (auto inner = command.chosen(); inner; inner = command.chosen()) {
    command = *inner;
    words += command.name() + " ";
  }
  return {command, words};
}

std::string unexpected(std::string_view word,
                       const command_line::Command& command,
                       const std::string& words) {
  std::set<std::string> known;
  for (const auto& option : command.options())
    for (const auto& name : option.long_names) known.insert("--" + name);
  const std::string name(word.substr(0, word.find('=')));
  if (!name.starts_with('-'))
    return fmt::format("'orbs {}' takes no further argument '{}'", trim(words), name);
  return fmt::format("'orbs {}' has no option {}{}", trim(words), name, closest(name, known));
}

// "0.000000 to 1000000.000000", as CLI11 writes the limits of a number that is no integer.
std::string plain_range(const std::string& range) {
  constexpr std::string_view kTo = " to ";
  const auto at = range.find(kTo);
  if (at == std::string::npos || range.find('.') == std::string::npos) return range;
  return fmt::format("{}{}{}", std::stod(range), kTo, std::stod(range.substr(at + kTo.size())));
}

// CLI11's "<option>: Value x not in range 1 to 8" and "<option>: x not in {a,b}".
std::string expected_value(const std::string& text) {
  constexpr std::string_view kRange = " not in range ";
  constexpr std::string_view kValue = "Value ";
  constexpr std::string_view kList = " not in {";
  const auto colon = text.find(": ");
  if (colon == std::string::npos) return text;
  const auto option = text.substr(0, colon + 2);
  const auto rest = text.substr(colon + 2);
  if (const auto at = rest.find(kRange); at != std::string::npos && rest.starts_with(kValue))
    return fmt::format("{}expected a number from {}, not '{}'", option,
                       plain_range(rest.substr(at + kRange.size())),
                       rest.substr(kValue.size(), at - kValue.size()));
  if (const auto at = rest.find(kList); at != std::string::npos && rest.ends_with('}')) {
    const auto words = split(rest.substr(at + kList.size(), rest.size() - at - kList.size() - 1), ',');
    const auto found = rest.substr(0, at);
    return fmt::format("{}expected one of {}, not '{}'{}", option, fmt::join(words, ", "), found,
                       closest(found, {words.begin(), words.end()}));
  }
  if (rest.find(" required ") != std::string::npos && rest.ends_with(" missing"))
    return option + "needs a value";
  return text;
}

}  // namespace

std::string parse_complaint(const command_line::Parsed& parsed, const command_line::Command& program) {
  const auto [command, words] = chosen_command(program);
  auto text = parsed.problem;
  if (parsed.has_extras) {
    const auto found = words_of(text.substr(text.find(": ") + 1));
    // The words that follow an unknown option are no arguments of their own.
    const auto option =
        std::find_if(found.begin(), found.end(), [](const auto& word) { return word.starts_with('-'); });
    if (!found.empty()) text = unexpected(option == found.end() ? found.front() : *option, command, words);
  } else if (text == "A subcommand is required") {
    std::vector<std::string> names;
    for (const auto& inner : command.commands()) names.push_back(inner.name());
    text = fmt::format("'orbs{}{}' needs a command; there {} {}", words.empty() ? "" : " ", trim(words),
                       names.size() == 1 ? "is" : "are", fmt::join(names, ", "));
  } else {
    text = expected_value(text);
  }
  return fmt::format("{}; 'orbs {}--help' lists the options", text, words);
}

}  // namespace orbs::cli

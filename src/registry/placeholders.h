#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace orbs::registry {

/// What {name} stands for in a command.
using Placeholders = std::map<std::string, std::string>;

/// The words that may stand in braces in `command` and, of these, the ones for the arguments of variants and
/// scenes, and for `executable` and `version_command`.
const std::set<std::string>& command_placeholders();
const std::set<std::string>& argument_placeholders();
const std::set<std::string>& executable_placeholders();

/// The complaint about the first thing in braces that is not among `known`, or about a brace without its
/// partner; nothing when all is well. "{{" and "}}" stand for the braces themselves.
std::optional<std::string> placeholder_problem(std::string_view text, const std::set<std::string>& known);

/// True when the text, or one of the texts, uses {name}.
bool uses_placeholder(std::string_view text, const std::string& name);
bool uses_placeholder(const std::vector<std::string>& texts, const std::string& name);

/// Every {name} replaced by its value, in one pass: what a value holds is not looked at again. The text must
/// have no placeholder_problem for the names in `values`.
std::string fill_placeholders(std::string_view text, const Placeholders& values);
std::vector<std::string> fill_placeholders(const std::vector<std::string>& texts, const Placeholders& values);

/// The text with these {names} replaced by texts that may hold placeholders themselves; every other {name}
/// stays. A text with a brace without its partner stays as it is.
std::string with_some_placeholders(const std::string& text, const Placeholders& texts);

/// The text as it stands in one with placeholders: "{{" for each "{".
std::string with_doubled_braces(std::string_view text);

}  // namespace orbs::registry

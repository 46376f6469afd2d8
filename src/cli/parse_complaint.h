#pragma once

#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): the name is the library's
class App;
class ParseError;
}  // namespace CLI

namespace orbs::cli {

/// What is wrong with the command line, in the words of our own messages: what was expected and found, the
/// nearest option, and where help is.
std::string parse_complaint(const CLI::ParseError& error, const CLI::App& app);

}  // namespace orbs::cli

#include "base/shell.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs {

namespace {

std::string quoted(const std::string& word) {
  constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-./:=,+@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string inner;
  for (const char c : word) inner += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return fmt::format("'{}'", inner);
}

}  // namespace

std::string shell_text(const std::vector<std::string>& words) {
  std::vector<std::string> parts;
  for (const auto& word : words) parts.push_back(quoted(word));
  return fmt::format("{}", fmt::join(parts, " "));
}

std::string shell_command(std::vector<std::string> environment, const std::vector<std::string>& argv) {
  environment.insert(environment.begin(), {"env", "-i"});
  environment.insert(environment.end(), argv.begin(), argv.end());
  return shell_text(environment);
}

}  // namespace orbs

#include "registry/plain_name.h"

#include "base/text.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace orbs::registry {

namespace {

// File systems take 255 bytes, and endings follow.
constexpr std::size_t kMostCharacters = 100;

// What lies in the folder of a run beside the folders of its renderers.
const std::set<std::string> kOwnNames{"jobs.json",    "junit.xml", "references", "results.csv",
                                      "results.json", "run.json",  "run.lock"};

bool is_letter_or_digit(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

bool is_plain(char c) { return is_letter_or_digit(c) || c == '-' || c == '_' || c == '.'; }

std::string problem_of(const std::string& name) {
  if (name.size() > kMostCharacters)
    return fmt::format("has {} characters, at most {} are allowed", name.size(), kMostCharacters);
  if (name.empty() || !is_letter_or_digit(name.front()) || !std::all_of(name.begin(), name.end(), is_plain))
    return fmt::format(
        "'{}' is no name: begin with a letter or a digit, then use letters, digits, '-', '_' and '.'",
        clean_text(name));
  if (kOwnNames.contains(name))
    return fmt::format("'{}' is what orbs itself calls something in the folder of a run; choose another name",
                       name);
  return "";
}

}  // namespace

std::string plain_name(json::ObjectReader& in, const std::string& key) {
  auto name = in.text(key);
  if (const auto problem = problem_of(name); !problem.empty()) in.fail(key, problem);
  return name;
}

}  // namespace orbs::registry

#include "registry/plain_name.h"

#include "base/text.h"

#include <set>

#include <fmt/format.h>

namespace orbs::registry {

namespace {

// What lies in the folder of a run beside the folders of its renderers.
const std::set<std::string> kOwnNames{"plan.json",    "junit.xml", "references", "results.csv",
                                      "results.json", "run.json",  "run.lock"};

std::string problem_of(const std::string& name) {
  if (name.size() > kMostNameCharacters)
    return fmt::format("has {} characters, at most {} are allowed", name.size(), kMostNameCharacters);
  if (!is_plain_name(name, "-_."))
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

#include "run/named_within.h"

namespace orbs::run {

std::string named_within(const std::filesystem::path& folder, std::string text) {
  const auto prefix = folder.string() + "/";
  for (auto at = text.find(prefix); at != std::string::npos; at = text.find(prefix, at))
    text.erase(at, prefix.size());
  return text;
}

}  // namespace orbs::run

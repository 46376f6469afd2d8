#include "registry/plain_name.h"

#include <algorithm>

#include <fmt/format.h>

namespace orbs::registry {

namespace {

// Folder separators, list separators, patterns, space; control characters, of which zero ends a path.
bool has_meaning(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte <= ' ' || byte == 0x7f || std::string_view("/\\,*?").find(c) != std::string_view::npos;
}

}  // namespace

std::string plain_name(json::ObjectReader& in, const std::string& key) {
  auto name = in.text(key);
  if (name.empty() || name.front() == '.' || std::any_of(name.begin(), name.end(), has_meaning))
    in.fail(key, fmt::format("'{}' is no name: use letters, digits, '-', '_' and '.'", name));
  return name;
}

}  // namespace orbs::registry

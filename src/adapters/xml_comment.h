#pragma once

#include "adapters/exporter.h"

#include <string>

#include <fmt/format.h>

namespace orbs::adapters {

/// A line with a name as a comment of XML. Names come from the user: two hyphens in a row would end the
/// comment (XML 1.0, 2.5), and the rest of the name would be read as markup.
inline std::string xml_comment(const std::string& name) {
  std::string text;
  for (const char c : comment_text(name)) text += c == '-' ? '_' : c;
  return fmt::format("<!-- {} -->\n", text);
}

}  // namespace orbs::adapters

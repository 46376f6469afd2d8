#pragma once

#include "adapters/exporter.h"
#include "base/matrix.h"

#include <string>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

/// Words of Mitsuba's scene description. Numbers are the shortest text that reads back as the same number.
namespace orbs::adapters::mitsuba {

inline std::string vector(Vec3d v) { return fmt::format("{}, {}, {}", v.x, v.y, v.z); }

inline std::string rgb(std::string_view name, Vec3d colour) {
  return fmt::format("<rgb name=\"{}\" value=\"{}\"/>", name, vector(colour));
}

/// Sixteen numbers row by row, for column vectors, as ours.
inline std::string to_world(const Mat4& matrix) {
  return fmt::format("<transform name=\"to_world\"><matrix value=\"{}\"/></transform>",
                     fmt::join(matrix.m, " "));
}

/// Names come from the user: two hyphens in a row would end the comment (XML 1.0, 2.5), and the rest of the
/// name would be read as markup.
inline std::string comment(const std::string& name) {
  std::string text;
  for (const char c : comment_text(name)) text += c == '-' ? '_' : c;
  return fmt::format("<!-- {} -->\n", text);
}

}  // namespace orbs::adapters::mitsuba

#pragma once

#include "base/matrix.h"

#include <string>

#include <fmt/format.h>

/// Directives of pbrt-v4's scene description. Numbers are the shortest text that reads back as the same
/// number.
namespace orbs::adapters::pbrt {

inline std::string numbers(Vec3d v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }

inline std::string rgb(const char* name, Vec3d colour) {
  return fmt::format("\"rgb {}\" [{}]", name, numbers(colour));
}

/// pbrt lists a matrix column after column.
inline std::string transform(const Mat4& m) {
  std::string text = "Transform [";
  for (std::size_t column = 0; column < 4; ++column)
    text += fmt::format("{}{} {} {} {}", column == 0 ? "" : "  ", m(0, column), m(1, column), m(2, column),
                        m(3, column));
  return text + "]\n";
}

}  // namespace orbs::adapters::pbrt

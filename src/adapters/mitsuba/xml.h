#pragma once

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

}  // namespace orbs::adapters::mitsuba

#pragma once

#include "base/matrix.h"
#include "base/vec.h"

#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

/// Words of HydraCore3's scene description. Numbers are the shortest text that reads back as the same number.
namespace orbs::adapters::hydra {

inline std::string numbers(Vec3d v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }

/// Sixteen numbers row by row, for column vectors, as ours.
inline std::string numbers(const Mat4& matrix) { return fmt::format("{}", fmt::join(matrix.m, " ")); }

/// `<name val="..."/>`, with what stands within it.
inline std::string value_node(const char* name, Vec3d value, const std::string& inner = "") {
  return inner.empty() ? fmt::format("<{} val=\"{}\"/>", name, numbers(value))
                       : fmt::format("<{0} val=\"{1}\">{2}</{0}>", name, numbers(value), inner);
}
inline std::string value_node(const char* name, double value) {
  return fmt::format("<{} val=\"{}\"/>", name, value);
}

}  // namespace orbs::adapters::hydra

#pragma once

#include "base/matrix.h"
#include "base/vec.h"

#include <string>

#include <fmt/format.h>

/// Statements of POV-Ray's scene description language. Numbers are the shortest text that reads back as the
/// same number.
namespace orbs::adapters::povray {

template <typename Real>
std::string vector(Vec3<Real> v) {
  return fmt::format("<{},{},{}>", v.x, v.y, v.z);
}

inline std::string colour(Vec3d c) { return "rgb " + vector(c); }

/// POV-Ray multiplies row vectors: its twelve numbers are our columns, one after the other.
inline std::string matrix(const Mat4& m) {
  std::string text = "matrix <";
  for (std::size_t column = 0; column < 4; ++column)
    text += fmt::format("{}{},{},{}", column == 0 ? "" : ", ", m(0, column), m(1, column), m(2, column));
  return text + ">";
}

}  // namespace orbs::adapters::povray

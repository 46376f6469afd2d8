#pragma once

#include <string>

#include <fmt/format.h>

namespace orbs {

/// The pixels x0 <= x < x1, y0 <= y < y1. y counts from the top.
struct Rectangle {
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;
  int y1 = 0;
};

/// Writes "[x0,y0,x1,y1]", the form of messages and results.
inline std::string rectangle_text(const Rectangle& r) {
  return fmt::format("[{},{},{},{}]", r.x0, r.y0, r.x1, r.y1);
}

}  // namespace orbs

#pragma once

#include <string>

namespace orbs {

/// Pixels x0 <= x < x1, y0 <= y < y1, y from the top.
struct Rectangle {
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;
  int y1 = 0;
};

/// "[x0,y0,x1,y1]", as messages and results write it.
std::string rectangle_text(const Rectangle& rectangle);

}  // namespace orbs

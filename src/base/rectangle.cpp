#include "base/rectangle.h"

#include <fmt/format.h>

namespace orbs {

std::string rectangle_text(const Rectangle& r) {
  return fmt::format("[{},{},{},{}]", r.x0, r.y0, r.x1, r.y1);
}

}  // namespace orbs

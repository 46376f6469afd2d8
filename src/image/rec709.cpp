#include "image/rec709.h"

#include "base/error.h"

#include <cmath>
#include <cstddef>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::image {

void check_rec709(const char* name, const std::array<float, 8>& found) {
  constexpr std::array kRec709{0.64F, 0.33F, 0.3F, 0.6F, 0.15F, 0.06F, 0.3127F, 0.329F};
  constexpr float kLastDigit = 0.001F;  // programs write them with three or four digits
  for (std::size_t i = 0; i < found.size(); ++i)
    if (!(std::fabs(found.at(i) - kRec709.at(i)) <= kLastDigit))
      throw InputError(
          fmt::format("its {} (red, green, blue, white) are {:.4g}, expected those of Rec.709, "
                      "{:.4g}; write linear Rec.709",
                      name, fmt::join(found, " "), fmt::join(kRec709, " ")));
}

}  // namespace orbs::image

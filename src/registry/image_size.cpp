#include "registry/image_size.h"

#include "base/error.h"

#include <fmt/format.h>

namespace orbs::registry {

std::string size_text(int divisor) { return divisor == 1 ? "1" : fmt::format("1/{}", divisor); }

SizeDivisor size_divisor(std::string_view text) {
  for (const auto divisor : kSizeDivisors)
    if (size_text(divisor) == text) return divisor;
  throw InputError(fmt::format("'{}' is no size; there are 1, 1/2, 1/4 and 1/8 of the full width", text));
}

}  // namespace orbs::registry

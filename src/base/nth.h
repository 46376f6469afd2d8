#pragma once

#include <cassert>
#include <cstddef>
#include <iterator>

namespace orbs {

/// items[index], for ids and counters that are int and for enums. In many of our ids -1 is "none", which must
/// not get here.
template <typename Items, typename Index>
constexpr decltype(auto) nth(Items&& items, Index index) {
  assert(static_cast<std::ptrdiff_t>(index) >= 0 && static_cast<std::size_t>(index) < std::size(items));
  return items[static_cast<std::size_t>(index)];
}

}  // namespace orbs

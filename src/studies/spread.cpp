#include "studies/spread.h"

#include <algorithm>
#include <cstddef>

namespace orbs::studies {

std::optional<Spread> spread_of(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  const std::size_t upper = values.size() / 2;
  const std::size_t lower = (values.size() - 1) / 2;
  return Spread{(values[lower] + values[upper]) / 2, values.front(), values.back()};
}

}  // namespace orbs::studies

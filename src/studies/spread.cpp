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

void write_spread(json::Writer& out, const char* name, const std::optional<Spread>& spread) {
  out.key(name);
  if (!spread) {
    out.null();
    return;
  }
  out.begin_object()
      .member("median", spread->median)
      .member("least", spread->least)
      .member("most", spread->most)
      .end_object();
}

}  // namespace orbs::studies

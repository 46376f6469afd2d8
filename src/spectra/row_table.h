#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace orbs::spectra {

/// Up to four functions of the wavelength on one regular grid, side by side, so that one look-up on a path
/// finds them in one line of the cache.
struct RowTable {
  float first_nm = 0;
  float rows_per_nm = 1;
  std::vector<std::array<float, 4>> rows;  // at least two
};

/// Linear between rows; outside the table the first or the last row.
inline std::array<float, 4> row_at(const RowTable& table, float wavelength_nm) {
  const float at = (wavelength_nm - table.first_nm) * table.rows_per_nm;
  const auto last = static_cast<float>(table.rows.size() - 1);
  if (!(at > 0)) return table.rows.front();
  if (at >= last) return table.rows.back();
  const auto i = static_cast<std::size_t>(at);
  const float share = at - static_cast<float>(i);
  const auto& low = table.rows[i];
  const auto& high = table.rows[i + 1];
  std::array<float, 4> out{};
  for (std::size_t c = 0; c < 4; ++c) out[c] = low[c] + share * (high[c] - low[c]);
  return out;
}

}  // namespace orbs::spectra

#pragma once

#include "spectra/refractive_index.h"
#include "spectra/spectrum.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

/// Measured tables as text: lines that start with # are comments, the first other line names the columns, the
/// rest are rows; cells are separated by commas.

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

struct TableFile {
  std::filesystem::path file;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
  std::vector<int> lines;  // of the rows in the file, from 1
};

/// InputError with file and line where a row has another number of cells than the header.
TableFile read_table_file(const std::filesystem::path& file);

/// The column over "wavelength_nm". InputError for a column that is not there (with the nearest name), a cell
/// that is no number, and all that tabulated() refuses.
Spectrum spectrum_of(const TableFile& table, const std::string& column, Beyond beyond);

/// Columns n and k over "wavelength_nm". InputError as above, and for n <= 0 or k < 0.
MetalIndex metal_of(const TableFile& table);

/// The row named `material` of a table with columns material, B1, C1, ... B4, C4 (Sellmeier) or material, A,
/// B, C, D (Cauchy). InputError for a material that is not there, with the nearest name.
RefractiveIndex glass_of(const TableFile& table, const std::string& material);

}  // namespace orbs::spectra

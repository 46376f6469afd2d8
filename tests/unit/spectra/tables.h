#pragma once

#include "spectra/table_file.h"

#include <stdexcept>

namespace orbs::spectra {

inline TableFile product_table(const std::string& name) {
  return read_table_file(std::filesystem::path(ORBS_SOURCE_DIR) / "data/common/spectra" / name);
}

inline TableFile expected_table(const std::string& name) {
  return read_table_file(std::filesystem::path(ORBS_SOURCE_DIR) / "tests/data" / name);
}

inline double expected_number(const TableFile& table, std::size_t row, std::size_t column) {
  return std::stod(table.rows.at(row).at(column));
}

/// The 24 reflectances of the ColorChecker, in chart order.
inline std::vector<Spectrum> colorchecker() {
  const TableFile table = product_table("colorchecker.csv");
  std::vector<Spectrum> patches;
  for (std::size_t i = 1; i < table.columns.size(); ++i)
    patches.push_back(spectrum_of(table, table.columns[i], Beyond::HoldsEnds));
  if (patches.size() != 24) throw std::runtime_error("colorchecker.csv: 24 patches expected");
  return patches;
}

}  // namespace orbs::spectra

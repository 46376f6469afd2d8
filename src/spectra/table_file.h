#pragma once

#include "spectra/refractive_index.h"
#include "spectra/spectrum.h"

#include <filesystem>
#include <string>
#include <vector>

/// Measured tables as text: lines that start with # are comments, the first other line names the columns, the
/// rest are rows; cells are separated by commas.
namespace orbs::spectra {

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

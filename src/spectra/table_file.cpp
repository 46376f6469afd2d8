#include "spectra/table_file.h"

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace orbs::spectra {

namespace {

[[noreturn]] void fail(const TableFile& table, std::size_t row, const std::string& problem) {
  throw InputError(fmt::format("{}:{}: {}", table.file.string(), table.lines[row], problem));
}

bool has_column(const TableFile& table, const std::string& name) {
  return std::find(table.columns.begin(), table.columns.end(), name) != table.columns.end();
}

std::size_t column_index(const TableFile& table, const std::string& name) {
  const auto found = std::find(table.columns.begin(), table.columns.end(), name);
  if (found != table.columns.end()) return static_cast<std::size_t>(found - table.columns.begin());
  throw InputError(fmt::format("{}: the table has no column '{}'{}", table.file.string(), name,
                               closest(name, {table.columns.begin(), table.columns.end()})));
}

double number_in(const TableFile& table, std::size_t row, std::size_t column) {
  const std::string& cell = table.rows[row][column];
  const auto number = to_number(trim(cell));
  if (!number) fail(table, row, fmt::format("{} must be a number, is '{}'", table.columns[column], cell));
  return *number;
}

double number_in(const TableFile& table, std::size_t row, const std::string& column) {
  return number_in(table, row, column_index(table, column));
}

std::size_t row_of(const TableFile& table, const std::string& material) {
  const std::size_t column = column_index(table, "material");
  std::set<std::string> names;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    if (table.rows[row][column] == material) return row;
    names.insert(table.rows[row][column]);
  }
  throw InputError(fmt::format("{}: the table has no material '{}'{}", table.file.string(), material,
                               closest(material, names)));
}

void check_at_least(const TableFile& table, const std::string& column, double least, bool may_be_least) {
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const double number = number_in(table, row, column);
    if (!(may_be_least ? number >= least : number > least))
      fail(
          table, row,
          fmt::format("{} must be {} {}, is {}", column, may_be_least ? "at least" : "above", least, number));
  }
}

}  // namespace

TableFile read_table_file(const std::filesystem::path& file) {
  TableFile table{.file = file, .columns = {}, .rows = {}, .lines = {}};
  int line = 0;
  for (const std::string& text : split(read_file(file), '\n')) {
    ++line;
    const auto trimmed = trim(text);
    if (trimmed.empty() || trimmed.starts_with('#')) continue;
    auto cells = split(trimmed, ',');
    if (table.columns.empty()) {
      table.columns = std::move(cells);
      continue;
    }
    if (cells.size() != table.columns.size())
      throw InputError(fmt::format("{}:{}: the row must have {} cells like the header, has {}", file.string(),
                                   line, table.columns.size(), cells.size()));
    table.rows.push_back(std::move(cells));
    table.lines.push_back(line);
  }
  if (table.rows.empty())
    throw InputError(fmt::format("{}: expected a header and at least one row, found none", file.string()));
  return table;
}

Spectrum spectrum_of(const TableFile& table, const std::string& column, Beyond beyond) {
  const std::size_t wavelength_column = column_index(table, "wavelength_nm");
  const std::size_t value_column = column_index(table, column);
  std::vector<double> wavelengths_nm;
  std::vector<double> values;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const double wavelength_nm = number_in(table, row, wavelength_column);
    if (row > 0 && !(wavelength_nm > wavelengths_nm.back()))
      fail(table, row,
           fmt::format("the wavelengths must ascend: {} nm follows {} nm", wavelength_nm,
                       wavelengths_nm.back()));
    wavelengths_nm.push_back(wavelength_nm);
    values.push_back(number_in(table, row, value_column));
  }
  return tabulated(std::move(wavelengths_nm), std::move(values), beyond);
}

MetalIndex metal_of(const TableFile& table) {
  check_at_least(table, "n", 0, false);
  check_at_least(table, "k", 0, true);
  return {spectrum_of(table, "n", Beyond::HoldsEnds), spectrum_of(table, "k", Beyond::HoldsEnds)};
}

RefractiveIndex glass_of(const TableFile& table, const std::string& material) {
  const std::size_t row = row_of(table, material);
  if (has_column(table, "A"))
    return Cauchy{number_in(table, row, "A"), number_in(table, row, "B"), number_in(table, row, "C"),
                  number_in(table, row, "D")};
  Sellmeier glass;
  for (std::size_t i = 0; i < glass.b.size(); ++i) {
    glass.b[i] = number_in(table, row, fmt::format("B{}", i + 1));
    glass.c_um2[i] = number_in(table, row, fmt::format("C{}", i + 1));
  }
  return glass;
}

}  // namespace orbs::spectra

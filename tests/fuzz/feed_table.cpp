#include "base/files.h"
#include "fuzz/feed.h"
#include "spectra/table_file.h"

#include <cmath>

namespace orbs::fuzz {

namespace {

void check_spectrum(const spectra::Spectrum& spectrum) {
  for (const double wavelength_nm : {300.0, 360.0, 555.5, 830.0, 1000.0})
    require(std::isfinite(spectra::value_at(spectrum, wavelength_nm)), "a spectrum has values");
}

}  // namespace

// A table of rows and columns; what it can be read as, it is read as.
std::string feed_table(std::string_view bytes) {
  static const ScratchFolder folder("orbs-feed-table");
  const auto file = folder.path() / "table.csv";
  write_file(file, bytes);
  return complaint_of(file.string(), [&] {
    const auto table = spectra::read_table_file(file);
    require(!table.rows.empty() && table.rows.size() == table.lines.size(), "a table has rows");
    for (const auto& row : table.rows)
      require(row.size() == table.columns.size(), "a row has a cell for each column");
    if (table.columns.front() == "material") {
      spectra::glass_of(table, table.rows.front().front());
    } else {
      const auto metal = spectra::metal_of(table);
      check_spectrum(metal.n);
      check_spectrum(metal.k);
    }
  });
}

}  // namespace orbs::fuzz

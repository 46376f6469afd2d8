#include "spectra/table_file.h"

#include "base/error.h"
#include "structure/source_files.h"

#include <functional>

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using namespace orbs::spectra;

// What the program says when `read` meets a file of this text; the folder is cut off.
std::string complaint(const std::string& text, const std::function<void(const TableFile&)>& read) {
  const structure::TestFolder folder("spectra-table");
  folder.write("t.csv", text);
  try {
    read(read_table_file(folder.path() / "t.csv"));
  } catch (const InputError& error) {
    std::string what = error.what();
    const std::string place = (folder.path() / "t.csv").string();
    for (auto at = what.find(place); at != std::string::npos; at = what.find(place))
      what.replace(at, place.size(), "t.csv");
    return what;
  }
  return "";
}

void read_value(const TableFile& table) { spectrum_of(table, "value", Beyond::HoldsEnds); }
void read_metal(const TableFile& table) { metal_of(table); }
void read_bk7(const TableFile& table) { glass_of(table, "BK7"); }

}  // namespace

TEST(TableFile, CommentsBlankLinesAndWindowsLineEndsAreNoRows) {
  const structure::TestFolder folder("spectra-table");
  folder.write("t.csv", "# a, b\r\nwavelength_nm,value\r\n\r\n400,1\r\n# 405,7\r\n410,3\r\n");
  const Spectrum spectrum = spectrum_of(read_table_file(folder.path() / "t.csv"), "value", Beyond::HoldsEnds);
  EXPECT_EQ(value_at(spectrum, 405), 2);
}

TEST(TableFile, EveryComplaintSaysWhereAndWhatWouldBeRight) {
  EXPECT_EQ(complaint("# nothing\n", read_value),
            "t.csv: expected a header and at least one row, found none");
  EXPECT_EQ(complaint("wavelength_nm,value\n400,1\n410\n", read_value),
            "t.csv:3: the row must have 2 cells like the header, has 1");
  EXPECT_EQ(complaint("wavelength_nm,values\n400,1\n", read_value),
            "t.csv: the table has no column 'value' (did you mean 'values'?)");
  EXPECT_EQ(complaint("wavelength_nm,value\n400,1\n410,x\n", read_value),
            "t.csv:3: value must be a number, is 'x'");
  EXPECT_EQ(complaint("wavelength_nm,value\n410,1\n400,2\n", read_value),
            "t.csv:3: the wavelengths must ascend: 400 nm follows 410 nm");
  EXPECT_EQ(complaint("wavelength_nm,n,k\n400,0,1\n", read_metal), "t.csv:2: n must be above 0, is 0");
  EXPECT_EQ(complaint("wavelength_nm,n,k\n400,1,-1\n", read_metal), "t.csv:2: k must be at least 0, is -1");
  EXPECT_EQ(complaint("material,A,B,C,D\nBK8,1,0,0,0\n", read_bk7),
            "t.csv: the table has no material 'BK7' (did you mean 'BK8'?)");
}

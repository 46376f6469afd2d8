#include "spectra/rgb.h"

#include "base/matrix.h"
#include "spectra/embedded_tables.h"
#include "spectra/observer.h"
#include "spectra/table_file.h"

#include <algorithm>

namespace orbs::spectra {

namespace {

constexpr float kGrid_nm = 5;  // of the basis and of D65

Mat4 columns(Vec3d a, Vec3d b, Vec3d c) {
  return {{a.x, b.x, c.x, 0, a.y, b.y, c.y, 0, a.z, b.z, c.z, 0, 0, 0, 0, 1}};
}

Vec3d xyz_of_chromaticity(double x, double y) { return {x / y, 1, (1 - x - y) / y}; }

// Chromaticities of the primaries: ITU-R BT.709, table 1. Their luminances are those that make the sum white.
Mat4 make_rgb_of_xyz() {
  const Vec3d red = xyz_of_chromaticity(0.64, 0.33);
  const Vec3d green = xyz_of_chromaticity(0.30, 0.60);
  const Vec3d blue = xyz_of_chromaticity(0.15, 0.06);
  const Vec3d luminance =
      transform_direction(*inverse(columns(red, green, blue)), xyz_of_light(illuminant("D65")));
  return *inverse(columns(red * luminance.x, green * luminance.y, blue * luminance.z));
}

// red, blue, D65; the basis holds its ends.
RowTable make_basis_table() {
  RowTable table{.first_nm = kShortestLight_nm, .rows_per_nm = 1 / kGrid_nm, .rows = {}};
  const auto rows = rgb_basis_rows();
  for (double nm = kShortestLight_nm; nm <= kLongestSeen_nm; nm += kGrid_nm) {
    const auto& row = *std::find_if(rows.begin(), rows.end() - 1, [&](const auto& r) { return r[0] >= nm; });
    table.rows.push_back({static_cast<float>(row[1]), static_cast<float>(row[3]),
                          static_cast<float>(value_at(illuminant("D65"), nm))});
  }
  return table;
}

RowTable make_matching_table() {
  RowTable table{.first_nm = kShortestSeen_nm, .rows_per_nm = 1, .rows = {}};
  const Observer& observer = cie_1931();
  for (std::size_t i = 0; i < observer.xbar.values.size(); ++i) {
    const Vec3d rgb = rgb_of_xyz({observer.xbar.values[i], observer.ybar.values[i], observer.zbar.values[i]});
    table.rows.push_back(
        {static_cast<float>(rgb.x), static_cast<float>(rgb.y), static_cast<float>(rgb.z), 0});
  }
  return table;
}

}  // namespace

Vec3d rgb_of_xyz(Vec3d xyz) {
  static const Mat4 kMatrix = make_rgb_of_xyz();
  return transform_direction(kMatrix, xyz);
}

Spectrum reflectance_of_rgb(Vec3d rgb) {
  std::vector<double> wavelengths_nm;
  std::vector<double> values;
  for (const auto& [nm, red, green, blue] : rgb_basis_rows()) {
    wavelengths_nm.push_back(nm);
    values.push_back(rgb.y + (rgb.x - rgb.y) * red + (rgb.z - rgb.y) * blue);
  }
  return tabulated(std::move(wavelengths_nm), std::move(values), Beyond::HoldsEnds);
}

RgbBasis rgb_basis_at(const std::array<float, 4>& wavelengths_nm) {
  static const RowTable table = make_basis_table();
  RgbBasis basis{};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto row = row_at(table, wavelengths_nm[i]);
    basis.red[i] = row[0];
    basis.blue[i] = row[1];
    basis.d65[i] = row[2];
  }
  return basis;
}

RgbMatching rgb_matching_at(const std::array<float, 4>& wavelengths_nm) {
  static const RowTable table = make_matching_table();
  RgbMatching matching{};
  for (std::size_t i = 0; i < 4; ++i) {
    const float nm = wavelengths_nm[i];
    if (nm < table.first_nm || nm > static_cast<float>(kLongestSeen_nm)) continue;
    const auto row = row_at(table, nm);
    matching.red[i] = row[0];
    matching.green[i] = row[1];
    matching.blue[i] = row[2];
  }
  return matching;
}

}  // namespace orbs::spectra

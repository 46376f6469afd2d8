#include "property/light_quadrature.h"

#include "base/matrix.h"
#include "unit/spectra/tables.h"

#include <algorithm>

namespace orbs::tests {

namespace {

constexpr double kFirst_nm = 360;
constexpr double kLast_nm = 830;
constexpr double kStep_nm = 0.1;  // midpoints; the tables bend at whole nanometres only

struct Matching {
  OfWavelength x = table_column("cie_1931_2deg.csv", "xbar", false);
  OfWavelength y = table_column("cie_1931_2deg.csv", "ybar", false);
  OfWavelength z = table_column("cie_1931_2deg.csv", "zbar", false);
};

// Not scaled.
Vec3d sum_of(const OfWavelength& light) {
  static const Matching matching;
  static const std::vector<Vec3d> rows = [] {
    std::vector<Vec3d> out;
    for (int i = 0; kFirst_nm + (i + 0.5) * kStep_nm < kLast_nm; ++i) {
      const double nm = kFirst_nm + (i + 0.5) * kStep_nm;
      out.push_back({matching.x(nm), matching.y(nm), matching.z(nm)});
    }
    return out;
  }();
  Vec3d sum;
  for (std::size_t i = 0; i < rows.size(); ++i)
    sum += rows[i] * light(kFirst_nm + (static_cast<double>(i) + 0.5) * kStep_nm);
  return sum;
}

Vec3d of_chromaticity(double x, double y) { return {x / y, 1, (1 - x - y) / y}; }

Mat4 columns(Vec3d a, Vec3d b, Vec3d c) {
  return {{a.x, b.x, c.x, 0, a.y, b.y, c.y, 0, a.z, b.z, c.z, 0, 0, 0, 0, 1}};
}

// Chromaticities of ITU-R BT.709.
const Mat4& xyz_of_rgb() {
  static const Mat4 matrix = [] {
    const Vec3d red = of_chromaticity(0.64, 0.33);
    const Vec3d green = of_chromaticity(0.30, 0.60);
    const Vec3d blue = of_chromaticity(0.15, 0.06);
    const Vec3d share = transform_direction(inverse(columns(red, green, blue)).value(),
                                            xyz_by_sum(illuminant_by_table("D65")));
    return columns(red * share.x, green * share.y, blue * share.z);
  }();
  return matrix;
}

}  // namespace

OfWavelength table_column(const std::string& file, const std::string& column, bool holds_ends) {
  const auto table = spectra::product_table(file);
  const auto found = std::find(table.columns.begin(), table.columns.end(), column);
  const auto index = static_cast<std::size_t>(found - table.columns.begin());
  std::vector<std::pair<double, double>> rows;
  for (const auto& row : table.rows) rows.emplace_back(std::stod(row.at(0)), std::stod(row.at(index)));
  return [rows, holds_ends](double nm) {
    if (nm <= rows.front().first || nm >= rows.back().first) {
      if (!holds_ends) return 0.0;
      return nm <= rows.front().first ? rows.front().second : rows.back().second;
    }
    std::size_t i = 1;
    while (rows[i].first < nm) ++i;
    const double share = (nm - rows[i - 1].first) / (rows[i].first - rows[i - 1].first);
    return rows[i - 1].second * (1 - share) + rows[i].second * share;
  };
}

Vec3d xyz_by_sum(const OfWavelength& light) {
  static const double equal_energy_y = sum_of([](double) { return 1.0; }).y;
  return sum_of(light) / equal_energy_y;
}

Vec3d rgb_by_sum(const OfWavelength& light) {
  static const Mat4 rgb_of_xyz = inverse(xyz_of_rgb()).value();
  return transform_direction(rgb_of_xyz, xyz_by_sum(light));
}

OfWavelength illuminant_by_table(const std::string& name) {
  const auto relative = table_column("illuminants.csv", name, false);
  const double scale = 1 / xyz_by_sum(relative).y;
  return [relative, scale](double nm) { return scale * relative(nm); };
}

Vec3d xyz_of_rgb_by_sum(Vec3d rgb) { return transform_direction(xyz_of_rgb(), rgb); }

double luminance_by_sum(Vec3d rgb) { return xyz_of_rgb_by_sum(rgb).y; }

}  // namespace orbs::tests

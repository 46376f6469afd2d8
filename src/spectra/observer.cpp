#include "spectra/observer.h"

#include "base/error.h"
#include "base/text.h"
#include "spectra/embedded_tables.h"

#include <set>
#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::spectra {

namespace {

template <std::size_t columns>
Spectrum column(std::span<const std::array<double, columns>> rows, std::size_t index) {
  std::vector<double> wavelengths_nm;
  std::vector<double> values;
  for (const auto& row : rows) {
    wavelengths_nm.push_back(row[0]);
    values.push_back(row[index]);
  }
  return tabulated(std::move(wavelengths_nm), std::move(values), Beyond::IsZero);
}

double integral_over_seen(const Spectrum& a, const Spectrum& b, const Spectrum& c) {
  return integral_of_product(a, b, c, kShortestSeen_nm, kLongestSeen_nm);
}

Observer make_observer() {
  const auto rows = cie_1931_rows();
  const Spectrum luminous = column(rows, 2);
  const double scale = 1 / integral_over_seen(luminous, constant(1), constant(1));
  return {scaled(column(rows, 1), scale), scaled(luminous, scale), scaled(column(rows, 3), scale)};
}

std::array<Spectrum, kIlluminants.size()> make_illuminants() {
  std::array<Spectrum, kIlluminants.size()> lights;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const Spectrum light = column(illuminant_rows(), i + 1);
    lights[i] = scaled(light, 1 / xyz_of_light(light).y);
  }
  return lights;
}

}  // namespace

const Observer& cie_1931() {
  static const Observer observer = make_observer();
  return observer;
}

const Spectrum& illuminant(std::string_view name) {
  static const auto lights = make_illuminants();
  for (std::size_t i = 0; i < kIlluminants.size(); ++i)
    if (kIlluminants[i] == name) return lights[i];
  throw InputError(fmt::format("'{}' is not one of the illuminants {}{}", name, fmt::join(kIlluminants, ", "),
                               closest(std::string(name), {kIlluminants.begin(), kIlluminants.end()})));
}

Vec3d xyz_of_light(const Spectrum& light) { return xyz_of_reflectance(constant(1), light); }

Vec3d xyz_of_reflectance(const Spectrum& reflectance, const Spectrum& light) {
  const Observer& observer = cie_1931();
  return {integral_over_seen(reflectance, light, observer.xbar),
          integral_over_seen(reflectance, light, observer.ybar),
          integral_over_seen(reflectance, light, observer.zbar)};
}

}  // namespace orbs::spectra

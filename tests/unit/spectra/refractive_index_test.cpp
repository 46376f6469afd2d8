#include "spectra/refractive_index.h"

#include "spectra/observer.h"
#include "spectra/rgb.h"
#include "unit/spectra/tables.h"

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using namespace orbs::spectra;

double normal_reflectance(std::complex<double> index) { return std::norm((index - 1.0) / (index + 1.0)); }

}  // namespace

TEST(RefractiveIndex, EverySellmeierGlassHasItsIndices) {
  const TableFile expected = expected_table("glasses_expected.csv");
  const TableFile glasses = product_table("glasses_sellmeier.csv");
  ASSERT_GT(expected.columns.size(), 1U);
  ASSERT_FALSE(expected.rows.empty());
  for (std::size_t column = 1; column < expected.columns.size(); ++column) {
    const RefractiveIndex glass = glass_of(glasses, expected.columns[column]);
    EXPECT_TRUE(is_dispersive(glass));
    EXPECT_GT(smallest_index(glass), 1.3) << expected.columns[column];
    for (std::size_t row = 0; row < expected.rows.size(); ++row)
      EXPECT_NEAR(index_at(glass, expected_number(expected, row, 0)), expected_number(expected, row, column),
                  2e-9)
          << expected.columns[column];
  }
}

// The Abbe number of BK7 from its formula.
TEST(RefractiveIndex, Bk7HasItsAbbeNumber) {
  const RefractiveIndex glass = glass_of(product_table("glasses_sellmeier.csv"), "BK7");
  const double d = index_at(glass, 587.5618);
  EXPECT_NEAR((d - 1) / (index_at(glass, 486.1327) - index_at(glass, 656.2725)), 64.1673, 5e-5);
}

// Two fits to water, made apart from each other; the sources agree to 1.3e-3.
TEST(RefractiveIndex, CauchyWaterIsNearSellmeierWater) {
  const RefractiveIndex sellmeier = glass_of(product_table("glasses_sellmeier.csv"), "water");
  for (const auto& [name, deviation] : {std::pair{"water", 1.25e-3}, std::pair{"water_3_term", 2e-4}}) {
    const RefractiveIndex cauchy = glass_of(product_table("glasses_cauchy.csv"), name);
    for (double nm = 380; nm <= 780; nm += 10)
      EXPECT_NEAR(index_at(cauchy, nm), index_at(sellmeier, nm), deviation) << name << " at " << nm;
  }
}

TEST(RefractiveIndex, OnlyAnIndexThatVariesIsDispersive) {
  EXPECT_FALSE(is_dispersive(constant(1.5)));
  EXPECT_FALSE(is_dispersive(Cauchy{.a = 1.5}));
  EXPECT_TRUE(is_dispersive(Cauchy{.a = 1.5, .b = 0.004}));
  EXPECT_FALSE(is_dispersive(Sellmeier{.b = {1.25, 0, 0, 0}, .c_um2 = {0, 0.02, 0, 0}}));
  EXPECT_TRUE(is_dispersive(Sellmeier{.b = {1.25}, .c_um2 = {0.01}}));
  EXPECT_TRUE(is_dispersive(tabulated({400, 700}, {1.52, 1.51}, Beyond::HoldsEnds)));
}

// A resonance in the middle of the visible range: n^2 is negative on its short side.
TEST(RefractiveIndex, AFormulaWithoutARealValueIsSeen) {
  EXPECT_TRUE(std::isnan(smallest_index(Sellmeier{.b = {1.0}, .c_um2 = {0.25}})));
  EXPECT_DOUBLE_EQ(smallest_index(Sellmeier{.b = {1.25}}), 1.5);
  EXPECT_LT(smallest_index(Cauchy{.a = 1, .b = -0.1}), 0);
}

TEST(RefractiveIndex, MetalsHaveTheirReflectanceAndColour) {
  const TableFile expected = expected_table("metals_expected.csv");
  ASSERT_FALSE(expected.rows.empty());
  for (std::size_t row = 0; row < expected.rows.size(); ++row) {
    const std::string& name = expected.rows[row][0];
    const MetalIndex metal = metal_of(product_table("metals/" + name + ".csv"));
    for (std::size_t i = 0; i < 6; ++i)
      EXPECT_NEAR(normal_reflectance(index_at(metal, 450 + 50.0 * static_cast<double>(i))),
                  expected_number(expected, row, 1 + i), 1e-6)
          << name;
    std::vector<double> wavelengths_nm;
    std::vector<double> reflectance;
    for (double nm = kShortestSeen_nm; nm <= kLongestSeen_nm; nm += 1) {
      wavelengths_nm.push_back(nm);
      reflectance.push_back(normal_reflectance(index_at(metal, nm)));
    }
    const Spectrum spectrum = tabulated(wavelengths_nm, reflectance, Beyond::HoldsEnds);
    const Vec3d rgb = rgb_of_xyz(xyz_of_reflectance(spectrum, illuminant("D65")));
    for (const auto& [value, column] : {std::pair{rgb.x, 7}, std::pair{rgb.y, 8}, std::pair{rgb.z, 9}})
      EXPECT_NEAR(value, expected_number(expected, row, static_cast<std::size_t>(column)), 3e-4) << name;
  }
}

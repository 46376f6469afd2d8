#include "spectra/spectrum.h"

#include "base/error.h"

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using namespace orbs::spectra;

std::string complaint(const std::vector<double>& wavelengths_nm, const std::vector<double>& values) {
  try {
    tabulated(wavelengths_nm, values, Beyond::HoldsEnds);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST(Spectrum, IsLinearBetweenSamplesRegularOrNot) {
  const Spectrum regular = tabulated({400, 410, 420, 430}, {1, 3, 2, 6}, Beyond::IsZero);
  const Spectrum irregular = tabulated({400, 410, 420, 460}, {1, 3, 2, 6}, Beyond::IsZero);
  EXPECT_EQ(regular.step_nm, 10);
  EXPECT_EQ(irregular.step_nm, 0);
  for (const Spectrum& spectrum : {regular, irregular}) {
    EXPECT_DOUBLE_EQ(value_at(spectrum, 400), 1);
    EXPECT_DOUBLE_EQ(value_at(spectrum, 402.5), 1.5);
    EXPECT_DOUBLE_EQ(value_at(spectrum, 410), 3);
    EXPECT_DOUBLE_EQ(value_at(spectrum, 418), 2.2);
  }
  EXPECT_DOUBLE_EQ(value_at(regular, 425), 4);
  EXPECT_DOUBLE_EQ(value_at(irregular, 430), 3);
  EXPECT_DOUBLE_EQ(value_at(irregular, 460), 6);
}

TEST(Spectrum, BeyondItsSamplesHoldsItsEndsOrIsZero) {
  const Spectrum held = tabulated({400, 410}, {1, 3}, Beyond::HoldsEnds);
  const Spectrum dark = tabulated({400, 410}, {1, 3}, Beyond::IsZero);
  EXPECT_EQ(value_at(held, 399.999), 1);
  EXPECT_EQ(value_at(held, 5000), 3);
  EXPECT_EQ(value_at(dark, 399.999), 0);
  EXPECT_EQ(value_at(dark, 410.001), 0);
  EXPECT_EQ(value_at(dark, 410), 3);
  EXPECT_EQ(value_at(constant(0.7), 123), 0.7);
}

TEST(Spectrum, IsConstantWhereEveryWavelengthOfLightSeesOneValue) {
  EXPECT_TRUE(is_constant(constant(0.3)));
  EXPECT_TRUE(is_constant(tabulated({400, 500, 610}, {2, 2, 2}, Beyond::HoldsEnds)));
  EXPECT_FALSE(is_constant(tabulated({400, 500, 610}, {2, 2, 2}, Beyond::IsZero)));
  EXPECT_TRUE(is_constant(tabulated({300, 500, 830}, {2, 2, 2}, Beyond::IsZero)));
  EXPECT_FALSE(is_constant(tabulated({400, 500, 610}, {2, 2.000001, 2}, Beyond::HoldsEnds)));
  EXPECT_TRUE(is_constant(tabulated({200, 300, 830, 900}, {1, 2, 2, 3}, Beyond::IsZero)))
      << "samples that no light reaches";
  EXPECT_FALSE(is_constant(tabulated({200, 310, 830}, {1, 2, 2}, Beyond::IsZero)));
}

TEST(Spectrum, RefusesSamplesThatAreNoFunctionOfTheWavelength) {
  EXPECT_EQ(complaint({}, {}), "a spectrum needs at least one sample, has none");
  EXPECT_EQ(complaint({1, 2}, {1}),
            "a spectrum needs one value for each wavelength, has 2 wavelengths and 1 values");
  EXPECT_EQ(complaint({400, 420, 410}, {1, 1, 1}),
            "the wavelengths of a spectrum must ascend: sample 3 at 410 nm follows 420 nm");
  EXPECT_EQ(complaint({400, 410}, {1, std::nan("")}),
            "sample 2 of the spectrum must be finite, is nan at 410 nm");
}

// x (2 - x) (1 + x) over [0, 1] = 2/2 + 1/3 - 1/4 = 13/12; with x in units of 100 nm from 400 nm on. The
// samples of the three factors lie at different places.
TEST(Spectrum, TheIntegralOfAProductIsExact) {
  const Spectrum a = tabulated({400, 437, 500}, {0, 0.37, 1}, Beyond::HoldsEnds);
  const Spectrum b = tabulated({300, 450, 600}, {3, 1.5, 0}, Beyond::HoldsEnds);
  const Spectrum c = tabulated({400, 425, 450, 475, 500}, {1, 1.25, 1.5, 1.75, 2}, Beyond::HoldsEnds);
  EXPECT_NEAR(integral_of_product(a, b, c, 400, 500), 100 * 13.0 / 12, 1e-12);
  EXPECT_NEAR(integral_of_product(constant(2), constant(3), constant(0.5), 360, 830), 3 * 470, 1e-12);
  // A dark end is an edge, not a slope: the factor is 1 on 20 nm of the range.
  const Spectrum edge = tabulated({410, 430}, {1, 1}, Beyond::IsZero);
  EXPECT_NEAR(integral_of_product(edge, constant(1), constant(1), 400, 500), 20, 1e-12);
}

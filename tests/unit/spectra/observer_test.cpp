#include "spectra/observer.h"

#include "base/error.h"
#include "spectra/rgb.h"
#include "unit/spectra/colour_difference.h"
#include "unit/spectra/tables.h"

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using namespace orbs::spectra;

}  // namespace

// Chromaticities of the tables by plain sums at 1 nm, computed apart from this program.
TEST(Observer, IlluminantsHaveTheirChromaticities) {
  struct White {
    std::string_view name;
    double x;
    double y;
  };
  for (const auto& [name, x, y] :
       {White{"D65", 0.312726931937, 0.329023221021}, White{"D50", 0.3456842005, 0.358504100097},
        White{"A", 0.447560768397, 0.407431233432}, White{"E", 0.333314380777, 0.333287705799}}) {
    const Vec3d white = xyz_of_light(illuminant(name));
    const double sum = white.x + white.y + white.z;
    EXPECT_NEAR(white.y, 1, 1e-14) << name;
    EXPECT_NEAR(white.x / sum, x, 2e-6) << name;
    EXPECT_NEAR(white.y / sum, y, 2e-6) << name;
  }
}

TEST(Observer, AnEqualEnergyLightOfOneHasTheLuminanceOne) {
  EXPECT_NEAR(xyz_of_light(constant(1)).y, 1, 1e-14);
}

TEST(Observer, AnUnknownIlluminantIsAnsweredWithTheKnownOnes) {
  try {
    illuminant("D56");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "'D56' is not one of the illuminants A, D50, D65, E (did you mean 'D50'?)");
  }
}

// 24 patches under 2 illuminants against sums of another program.
TEST(Observer, ColorCheckerPatchesHaveTheirColours) {
  const TableFile expected = expected_table("colorchecker_expected.csv");
  const auto patches = colorchecker();
  ASSERT_EQ(expected.rows.size(), 2 * patches.size());
  double worst = 0;
  for (std::size_t row = 0; row < expected.rows.size(); ++row) {
    const Spectrum& light = illuminant(expected.rows[row][0]);
    const Vec3d xyz = xyz_of_reflectance(patches[row % patches.size()], light);
    const auto number = [&](std::size_t column) { return expected_number(expected, row, column); };
    const Lab lab{number(6), number(7), number(8)};
    const double difference = ciede2000(lab_of(xyz, xyz_of_light(light)), lab);
    worst = std::max(worst, difference);
    EXPECT_LT(difference, 0.01) << expected.rows[row][0] << " " << expected.rows[row][2];
    // The other program's white is the rounded one of the standard, 1.6e-4 to 2.4e-4 from D65.
    const Vec3d rgb = rgb_of_xyz(xyz);
    EXPECT_LT(largest_magnitude(rgb - Vec3d{number(9), number(10), number(11)}), 3e-4)
        << expected.rows[row][0] << " " << expected.rows[row][2];
  }
  RecordProperty("worst_ciede2000", fmt::format("{:.2e}", worst));
}

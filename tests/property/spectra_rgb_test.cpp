// RGB colours as spectra: exact, for colours of any size and sign.
#include "base/matrix.h"
#include "spectra/observer.h"
#include "spectra/rgb.h"

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using namespace orbs::spectra;

constexpr std::array kLevels{-0.5, 0.0, 0.1, 0.5, 1.0, 2.0, 1000.0};

template <typename F>
void for_each_colour(const F& f) {
  for (const double r : kLevels)
    for (const double g : kLevels)
      for (const double b : kLevels) f(Vec3d{r, g, b});
}

Vec3d seen_under_d65(const Spectrum& reflectance) {
  return rgb_of_xyz(xyz_of_reflectance(reflectance, illuminant("D65")));
}

}  // namespace

TEST(RgbSpectra, EveryColourComesBack) {
  double worst = 0;
  for_each_colour([&](Vec3d rgb) {
    const Vec3d back = seen_under_d65(reflectance_of_rgb(rgb));
    worst = std::max(worst, largest_magnitude(back - rgb) / std::max(1.0, largest_magnitude(rgb)));
  });
  EXPECT_LT(worst, 1e-9);
  RecordProperty("worst_round_trip", fmt::format("{:.2e}", worst));
}

TEST(RgbSpectra, ColoursOfRealSurfacesAreReflectancesThatLoseLight) {
  int seen = 0;
  for_each_colour([&](Vec3d rgb) {
    if (std::min({rgb.x, rgb.y, rgb.z}) < 0 || largest(rgb) > 1) return;
    for (const double value : reflectance_of_rgb(rgb).values) {
      EXPECT_GE(value, -1e-15);
      EXPECT_LE(value, 1 + 1e-15);
      ++seen;
    }
  });
  EXPECT_GT(seen, 0);
}

TEST(RgbSpectra, GreyIsConstantAndWhiteLightIsD65) {
  for (const double level : kLevels) EXPECT_TRUE(is_constant(reflectance_of_rgb({level, level, level})));
  for (float nm = 300; nm <= 830; nm += 3.7F) {
    const RgbBasis basis = rgb_basis_at({nm, nm, nm, nm});
    const auto d65 = static_cast<float>(value_at(illuminant("D65"), nm));
    EXPECT_EQ(reflectances({0.3F, 0.3F, 0.3F}, basis)[0], 0.3F);
    EXPECT_NEAR(lights({1, 1, 1}, basis)[0], d65, 1e-6);
  }
  const Vec3d white = rgb_of_xyz(xyz_of_light(illuminant("D65")));
  EXPECT_LT(largest_magnitude(white - Vec3d{1, 1, 1}), 1e-14);
}

TEST(RgbSpectra, TheBasisOfPathsIsThatOfTheSpectra) {
  for_each_colour([&](Vec3d rgb) {
    const Spectrum reflectance = reflectance_of_rgb(rgb);
    const std::array wavelengths_nm{333.3F, 431.7F, 560.0F, 829.9F};
    const auto values = reflectances(cast<float>(rgb), rgb_basis_at(wavelengths_nm));
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(values[i], value_at(reflectance, wavelengths_nm[i]),
                  1e-6 * std::max(1.0, largest_magnitude(rgb)));
  });
}

// Rec.709's own luminances are rounded to four digits.
TEST(RgbSpectra, PrimariesHaveTheLuminancesOfRec709) {
  const Vec3d x = rgb_of_xyz({1, 0, 0});
  const Vec3d y = rgb_of_xyz({0, 1, 0});
  const Vec3d z = rgb_of_xyz({0, 0, 1});
  const auto xyz_of_rgb = inverse(Mat4{{x.x, y.x, z.x, 0, x.y, y.y, z.y, 0, x.z, y.z, z.z, 0, 0, 0, 0, 1}});
  ASSERT_TRUE(xyz_of_rgb);
  EXPECT_NEAR(transform_direction(*xyz_of_rgb, {1, 0, 0}).y, 0.2126, 1.5e-4);
  EXPECT_NEAR(transform_direction(*xyz_of_rgb, {0, 1, 0}).y, 0.7152, 1.5e-4);
  EXPECT_NEAR(transform_direction(*xyz_of_rgb, {0, 0, 1}).y, 0.0722, 1.5e-4);
}

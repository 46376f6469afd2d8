// Spectral images against integrals over the wavelengths in double (light_quadrature.h).
#include "property/light_images.h"
#include "property/light_quadrature.h"
#include "spectra/rgb.h"
#include "unit/spectra/colour_difference.h"
#include "unit/spectra/tables.h"

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using namespace orbs::tests;

// Patches of the chart lie in a grid; of the image at a tenth of its size, the inner six pixels each way.
constexpr int kColumns = 6;
constexpr int kRows = 4;
constexpr int kSide = 6;

struct Patch {
  std::string column;
  Vec3d expected;
  Vec3d mean;
  Vec3d noise;  // root mean square over the patch's pixels
};

Patch look_at_patch(const image::Image& image,
                    int index,
                    const std::string& column,
                    const OfWavelength& light) {
  const auto reflectance = table_column("colorchecker.csv", column, true);
  Patch patch{column, rgb_by_sum([&](double nm) { return reflectance(nm) * light(nm); }), {}, {}};
  // Middle of the patch in the full image: 94 + 86.5 column, 80 + 86.5 row.
  const int x0 = static_cast<int>(std::lround(9.4 + 8.65 * (index % kColumns))) - kSide / 2;
  const int y0 = static_cast<int>(std::lround(8.0 + 8.65 * (index / kColumns))) - kSide / 2;
  constexpr double kShare = 1.0 / (kSide * kSide);
  for (int y = y0; y < y0 + kSide; ++y)
    for (int x = x0; x < x0 + kSide; ++x) {
      const Vec3d pixel{image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
      patch.mean += pixel * kShare;
      patch.noise += (pixel - patch.expected) * (pixel - patch.expected) * kShare;
    }
  patch.noise = {std::sqrt(patch.noise.x), std::sqrt(patch.noise.y), std::sqrt(patch.noise.z)};
  return patch;
}

double largest_of(Vec3d v) { return std::max({v.x, v.y, v.z}); }

image::Image chart(const std::string& light, int samples_per_pixel) {
  auto scene =
      scene::load_scene(std::filesystem::path(ORBS_SOURCE_DIR) /
                        "data/cases/appearance/e2_spectral_accuracy" / ("macbeth_chart_" + light + ".json"));
  scene.camera.width_px = 62;
  scene.camera.height_px = 42;
  const std::atomic<bool> never{false};
  return tracer::render(tracer::make_world(scene), {.samples_per_pixel = samples_per_pixel}, never,
                        [](const tracer::Progress&) {})
      .image;
}

// For each of the 24 patches, with its expected colour.
void for_each_patch(const std::string& light,
                    int samples_per_pixel,
                    const std::function<void(const Patch&)>& visit) {
  const auto columns = spectra::product_table("colorchecker.csv").columns;
  const auto illuminant = illuminant_by_table(light);
  const auto image = chart(light, samples_per_pixel);
  for (int i = 0; i < kColumns * kRows; ++i)
    visit(look_at_patch(image, i, columns.at(static_cast<std::size_t>(i) + 1), illuminant));
}

}  // namespace

// 36 pixels with 256 samples each know their mean to about 0.05.
TEST(SpectralLight, TheColorCheckerIsWithinATenthOfADifferenceOfItsIntegrals) {
  for (const std::string light : {"D65", "D50"}) {
    const Vec3d white = xyz_by_sum(illuminant_by_table(light));
    const auto lab = [&](Vec3d rgb) { return spectra::lab_of(xyz_of_rgb_by_sum(rgb), white); };
    double worst = 0;
    for_each_patch(light, 256, [&](const Patch& patch) {
      const double difference = spectra::ciede2000(lab(patch.mean), lab(patch.expected));
      EXPECT_LT(difference, 0.1) << patch.column << " under " << light;
      worst = std::max(worst, difference);
    });
    RecordProperty("worst_ciede2000_" + light, fmt::format("{:.4f}", worst));
  }
}

TEST(SpectralLight, TheColourNoiseOf64SamplesIsBelowAHundredthOfWhite) {
  for (const std::string light : {"D65", "D50"}) {
    double worst = 0;
    for_each_patch(light, 64, [&](const Patch& patch) {
      EXPECT_LT(largest_of(patch.noise), 0.01) << patch.column << " under " << light;
      worst = std::max(worst, largest_of(patch.noise));
    });
    RecordProperty("worst_noise_" + light, fmt::format("{:.5f}", worst));
  }
}

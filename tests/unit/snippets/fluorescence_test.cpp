#include "snippets/fluorescence.h"

#include "base/random.h"

#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace {

using namespace snippets;
using Kernel = TentKernel<double>;
using Matrix = ReradiationMatrix<double>;

// As the fluorescent spheres of the suite have it, and one whose absorption and emission overlap.
const std::array kKernels{Kernel{0.025, 370, 40, 650, 50}, Kernel{0.01, 450, 40, 650, 50},
                          Kernel{0.02, 500, 60, 520, 30}};

// Bins B, G, R.
const Matrix kThreeBins{400, 100, 3, {0.30, 0, 0, 0.35, 0.50, 0, 0.10, 0.20, 0.60}};

// Midpoint rule; K is linear in pieces.
template <typename F>
double integral(double from, double to, const F& f) {
  constexpr int kSteps = 10000;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) sum += f(from + (to - from) * (i + 0.5) / kSteps);
  return sum * (to - from) / kSteps;
}

double number(std::uint64_t a, std::uint64_t b) { return orbs::unit_random(orbs::mix(a, b)); }

}  // namespace

TEST(Fluorescence, KernelsOnlyLengthenWavelengths) {
  for (const Kernel& kernel : kKernels) {
    EXPECT_EQ(kernel_at(kernel, kernel.emitted_nm, kernel.emitted_nm), 0);
    EXPECT_EQ(kernel_at(kernel, kernel.emitted_nm + 1, kernel.emitted_nm), 0);
  }
  EXPECT_DOUBLE_EQ(kernel_at(kKernels[0], 370.0, 650.0), 0.025);
  EXPECT_DOUBLE_EQ(kernel_at(kKernels[0], 350.0, 650.0), 0.0125);
  EXPECT_DOUBLE_EQ(kernel_at(kKernels[0], 370.0, 640.0), 0.02);
  EXPECT_DOUBLE_EQ(kernel_at(kKernels[0], 350.0, 640.0), 0.0125);  // the smaller of the two
}

TEST(Fluorescence, EnergyOutIsTheIntegralOverEmittedWavelengths) {
  EXPECT_NEAR(emitted_share(kKernels[0], 370.0), 1.25, 1e-14);  // 0.025 per nm times a tent of area 50 nm
  for (const Kernel& kernel : kKernels)
    for (double nm = 300; nm < 600; nm += 7.3)
      EXPECT_NEAR(emitted_share(kernel, nm),
                  integral(550, 750, [&](double out) { return kernel_at(kernel, nm, out); }) +
                      integral(400, 550, [&](double out) { return kernel_at(kernel, nm, out); }),
                  2e-4)
          << nm;
}

TEST(Fluorescence, TheLargestGainSaysWhereEnergyIsMade) {
  const auto bright = largest_gain(kKernels[0], [](double nm) { return nm < 400 ? 0.1 : 0.2; });
  EXPECT_NEAR(bright.gain, 1.35, 1e-14);
  EXPECT_EQ(bright.absorbed_nm, 370);
  Kernel scaled = kKernels[0];
  scaled.peak_per_nm *= 0.9 / 1.25;
  EXPECT_NEAR(largest_gain(scaled, [](double) { return 0.0; }).gain, 0.9, 1e-14);
}

TEST(Fluorescence, AbsorbedWavelengthsAreDrawnInProportionToTheKernel) {
  for (const Kernel& kernel : kKernels)
    for (const double out : {605.0, 630.0, 650.0, 690.0, 495.0, 510.0, 530.0, 545.0}) {
      const double all = integral(300, out, [&](double in) { return kernel_at(kernel, in, out); });
      const auto first = sample_absorbed(kernel, out, 0.5);
      EXPECT_NEAR(first.weight, all, 1e-4 * std::max(1.0, all)) << out;
      if (first.pdf == 0) continue;
      EXPECT_NEAR(integral(300, 700, [&](double in) { return pdf_absorbed(kernel, in, out); }), 1, 2e-4)
          << out;
      double last = 0;
      for (double u = 0.005; u < 1; u += 0.01) {
        const auto sample = sample_absorbed(kernel, out, u);
        EXPECT_LT(sample.absorbed_nm, out);
        EXPECT_GT(sample.absorbed_nm, last);
        last = sample.absorbed_nm;
        EXPECT_NEAR(sample.pdf, pdf_absorbed(kernel, sample.absorbed_nm, out), 1e-12);
        EXPECT_NEAR(sample.pdf * sample.weight, kernel_at(kernel, sample.absorbed_nm, out), 1e-12);
        // The share below the wavelength drawn is the number it was drawn with.
        EXPECT_NEAR(
            integral(300, sample.absorbed_nm, [&](double in) { return kernel_at(kernel, in, out); }) / all, u,
            2e-4);
      }
    }
}

TEST(Fluorescence, NothingIsAbsorbedForAWavelengthThatIsNotEmitted) {
  for (const double out : {300.0, 599.0, 701.0}) {
    const auto sample = sample_absorbed(kKernels[0], out, 0.3);
    EXPECT_EQ(sample.pdf, 0);
    EXPECT_EQ(sample.weight, 0);
    EXPECT_EQ(pdf_absorbed(kKernels[0], 370.0, out), 0);
  }
  EXPECT_EQ(sample_absorbed(kThreeBins, 399.0, 0.3).weight, 0);
  EXPECT_EQ(sample_absorbed(kThreeBins, 700.0, 0.3).weight, 0);
}

TEST(Fluorescence, TheColumnsOfAMatrixAreWhatComesOutOfABin) {
  EXPECT_DOUBLE_EQ(emitted_share(kThreeBins, 0), 0.75);
  EXPECT_DOUBLE_EQ(emitted_share(kThreeBins, 1), 0.70);
  EXPECT_DOUBLE_EQ(emitted_share(kThreeBins, 2), 0.60);
}

TEST(Fluorescence, AMatrixIsSampledByItsRows) {
  // G comes from B (0.35) and from G itself (0.5).
  const auto from_blue = sample_absorbed(kThreeBins, 530.0, 0.2);
  EXPECT_DOUBLE_EQ(from_blue.weight, 0.85);
  EXPECT_DOUBLE_EQ(from_blue.pdf, 0.35 / 0.85 / 100);
  EXPECT_NEAR(from_blue.absorbed_nm, 400 + 100 * 0.2 * 0.85 / 0.35, 1e-10);
  const auto from_green = sample_absorbed(kThreeBins, 530.0, 0.9);
  EXPECT_DOUBLE_EQ(from_green.absorbed_nm, 530);
  EXPECT_DOUBLE_EQ(from_green.pdf, 0.5 / 0.85);
  // The largest number below 1 chooses the last bin with a share, not one beyond it.
  EXPECT_DOUBLE_EQ(sample_absorbed(kThreeBins, 450.0, 1 - 1e-16).absorbed_nm, 450);
}

// A closed room whose walls glow with Le and re-radiate by P: L = (I - P)^-1 Le, found by paths that follow
// the sampled wavelengths.
TEST(Fluorescence, AFluorescentFurnaceHasItsLevels) {
  const std::array glow{1.0, 0.5, 0.25};
  const std::array expected{1.428571, 2.000000, 1.982143};
  constexpr std::uint64_t kPaths = 100000;
  for (std::size_t seen = 0; seen < 3; ++seen) {
    double sum = 0;
    double squares = 0;
    for (std::uint64_t path = 0; path < kPaths; ++path) {
      double nm = 450 + 100.0 * static_cast<double>(seen);
      double weight = 1;
      double light = 0;
      for (std::uint64_t bounce = 0; bounce < 60 && weight > 0; ++bounce) {
        light += weight * glow[bin_of(kThreeBins, nm)];
        const auto absorbed = sample_absorbed(kThreeBins, nm, number(path, 8 * bounce + seen));
        weight *= absorbed.weight;
        nm = absorbed.absorbed_nm;
      }
      sum += light;
      squares += light * light;
    }
    const double mean = sum / kPaths;
    const double error = std::sqrt((squares / kPaths - mean * mean) / kPaths);
    EXPECT_NEAR(mean, expected[seen], 4 * error + 1e-6);
  }
}

// A patch under blue light of irradiance 1 shows the first column over pi.
TEST(Fluorescence, APatchUnderBlueLightShowsTheFirstColumn) {
  for (const auto& [nm, radiance] :
       {std::pair{450.0, 0.095493}, std::pair{550.0, 0.111408}, std::pair{650.0, 0.031831}}) {
    double sum = 0;
    constexpr int kSteps = 10000;
    for (int i = 0; i < kSteps; ++i) {
      const auto absorbed = sample_absorbed(kThreeBins, nm, (i + 0.5) / kSteps);
      if (absorbed.absorbed_nm < 500) sum += absorbed.weight / kSteps;
    }
    EXPECT_NEAR(sum * std::numbers::inv_pi, radiance, 5e-5);
  }
}

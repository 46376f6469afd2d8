// Fluorescence against the linear equations of an integrating sphere and against integrals of its kernel.
#include "property/light_images.h"
#include "property/light_quadrature.h"

#include <numbers>

#include <fmt/ranges.h>
#include <gtest/gtest.h>

namespace {

using namespace orbs;
using namespace orbs::tests;

void expect_colour(const image::Image& image, Vec3d expected) {
  const std::array<double, 3> channels{expected.x, expected.y, expected.z};
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const double error = error_of_mean(image, channel);
    EXPECT_NEAR(mean_of_channel(image, channel), channels[channel], 4 * error + 1e-5)
        << "channel " << channel;
    EXPECT_LT(error, 0.01 * channels[1]) << "channel " << channel;
  }
}

constexpr std::size_t kBins = 5;
constexpr double kFirst_nm = 300;
constexpr double kWidth_nm = 100;
constexpr double kReflectance = 0.3;
using PerBin = std::array<double, kBins>;
// Rows are outgoing, columns are absorbed wavelengths. Each column plus the reflectance is below 1.
constexpr std::array<PerBin, kBins> kShares{{{0, 0, 0, 0, 0},
                                             {0.2, 0, 0, 0, 0},
                                             {0.25, 0.3, 0, 0, 0},
                                             {0.1, 0.2, 0.4, 0, 0},
                                             {0, 0.1, 0.15, 0.3, 0}}};

// Radiosity of the wall of a sphere around a black light of radiance 1, which covers the fraction `hidden` of
// the wall as seen from each of its points: B = P (E + (1 - hidden) B), E = pi hidden. P is triangular, so
// each bin follows from those below it.
PerBin radiosities(double hidden) {
  PerBin b{};
  for (std::size_t out = 0; out < kBins; ++out) {
    const double light = std::numbers::pi * hidden;
    double arrived = kReflectance * light;
    for (std::size_t in = 0; in < out; ++in) arrived += kShares[out][in] * (light + (1 - hidden) * b[in]);
    b[out] = arrived / (1 - kReflectance * (1 - hidden));
  }
  return b;
}

}  // namespace

// (I - P)^-1 P E in each bin, as the camera records it. From every point of the wall the light covers (r /
// R)^2 of the cosine-weighted hemisphere. A second light outside illuminates nothing, but its selection must
// not depend on whether the path before was reflected or re-radiated.
TEST(FluorescentLight, TheWallOfAnIntegratingSphereSolvesItsLinearEquations) {
  constexpr double kLight = 0.3;
  constexpr std::string_view kFarAway = R"([{"translate": [9, 0, 0]}])";
  std::string rows;
  for (const PerBin& row : kShares)
    rows += fmt::format("{}[{}]", rows.empty() ? "" : ", ", fmt::join(row, ", "));
  const auto content = fmt::format(
      R"("spectra": [{{"name": "E", "constant": 1}}], )"
      R"("materials": [{{"name": "wall", "type": "fluorescent", "reflectance": [{0}, {0}, {0}], )"
      R"("reradiation": {{"first_nm": {1}, "width_nm": {2}, "bins": {3}, "shares": [{4}]}}}}], )"
      R"("shapes": [{{"type": "sphere", "centre": [0, 0, 0], "radius": 1, "material": "wall"}}], )"
      R"("lights": [{{"type": "sphere", "radius": {5}, "radiance": {{"spectrum": "E"}}}}, )"
      R"({{"type": "sphere", "radius": {5}, "matrix": {6}, "radiance": {{"spectrum": "E"}}}}])",
      kReflectance, kFirst_nm, kWidth_nm, kBins, rows, kLight, kFarAway);
  const PerBin b = radiosities(kLight * kLight);
  const double plain =
      kReflectance * std::numbers::pi * kLight * kLight / (1 - kReflectance * (1 - kLight * kLight));
  const Vec3d expected = rgb_by_sum([&](double nm) {
    const auto bin = static_cast<std::size_t>((nm - kFirst_nm) / kWidth_nm);
    return (bin < kBins ? b[bin] : plain) / std::numbers::pi;
  });
  const auto text = scene_of({.position = "[0, 0, 0.6]", .look_at = "[0, 0.1, 1]", .fov_deg = 60}, content);
  for (const auto transport : {scene::LightTransport::Bispectral, scene::LightTransport::PolarisedBispectral})
    expect_colour(image_of(text, 512, {.transport = transport}), expected);
}

// A convex ball in an environment of radiance 1 at all wavelengths shows its reflectance plus what its kernel
// emits for all shorter wavelengths, down to 300 nm, below which there is no light.
TEST(FluorescentLight, ABallWithATentKernelHasTheColourOfItsIntegral) {
  const auto tent = [](double x) { return std::max(0.0, 1 - std::abs(x)); };
  const auto kernel = [&](double in, double out) {
    return 0.0055 * std::min(tent((in - 360) / 90), tent((out - 520) / 120));
  };
  const Vec3d expected = rgb_by_sum([&](double out) {
    constexpr double kStep = 0.5;
    double sum = 0.25;
    for (double in = 300 + kStep / 2; in < std::min(out, 460.0); in += kStep) sum += kernel(in, out) * kStep;
    return sum;
  });
  const auto text =
      scene_of({}, R"("spectra": [{"name": "E", "constant": 1}], "environment": {"spectrum": "E"},
             "materials": [{"name": "m", "type": "fluorescent", "reflectance": [0.25, 0.25, 0.25],
                            "reradiation": {"peak_per_nm": 0.0055, "absorbed_nm": 360, "absorbed_reach_nm": 90,
                                            "emitted_nm": 520, "emitted_reach_nm": 120}}],
             "shapes": [{"type": "sphere", "centre": [0, 0, 0], "radius": 1, "material": "m"}])");
  expect_colour(image_of(text, 256), expected);
  EXPECT_GT(expected.y, 0.4);  // much of it is fluorescence
}

// A transposed matrix would convert red to blue: in light of long wavelengths alone, a ball that emits only
// at shorter wavelengths must show its reflectance alone.
TEST(FluorescentLight, LightOfLongWavelengthsExcitesNothing) {
  const auto red = [](double nm) { return std::max(0.0, 1 - std::abs(nm - 650) / 40); };
  const Vec3d expected = rgb_by_sum([&](double nm) { return 0.25 * red(nm); });
  const auto text = scene_of(
      {},
      R"("spectra": [{"name": "red", "wavelengths": [610, 650, 690], "values": [0, 1, 0], "beyond": "zero"}],
             "environment": {"spectrum": "red"},
             "materials": [{"name": "m", "type": "fluorescent", "reflectance": [0.25, 0.25, 0.25],
                            "reradiation": {"first_nm": 400, "width_nm": 100, "bins": 3,
                                            "shares": [[0, 0, 0], [0.7, 0, 0], [0, 0.7, 0]]}}],
             "shapes": [{"type": "sphere", "centre": [0, 0, 0], "radius": 1, "material": "m"}])");
  const auto image = image_of(text, 256);
  const double error = error_of_mean(image, 0);
  EXPECT_NEAR(mean_of_channel(image, 0), expected.x, 4 * error);
  EXPECT_LT(error, 0.02 * expected.x);
}

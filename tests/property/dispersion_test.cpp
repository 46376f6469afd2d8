// The directions of each wavelength against Snell's law in double, and the cost of dispersion where there is
// none.
#include "property/light_images.h"
#include "property/light_quadrature.h"

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using namespace orbs::tests;

constexpr double kRadians = std::numbers::pi / 180;

// n of N-BK7 by Sellmeier's formula with the coefficients of the glass catalogue.
double index_of_bk7(double nm) {
  const double l2 = nm * nm * 1e-6;
  return std::sqrt(1 + 1.03961212 * l2 / (l2 - 0.00600069867) + 0.231792344 * l2 / (l2 - 0.0200179144) +
                   1.01046945 * l2 / (l2 - 103.560653));
}

// A prism with edges along z; the angles of the outside at entry and exit are `entry` and `exit` degrees.
constexpr double kEntry_deg = 150;
constexpr double kExit_deg = 30;
constexpr double kHalfFace = 0.001;  // so small that the beam through it is a spot on the screen

Vec3d direction_at(double degrees) { return {std::cos(degrees * kRadians), std::sin(degrees * kRadians), 0}; }

// Snell's law in vector form; `eta`: beyond over this side. The normal points against d.
Vec3d refracted(Vec3d d, Vec3d normal, double eta) {
  const double cos_i = -dot(d, normal);
  const double cos_t = std::sqrt(1 - (1 - cos_i * cos_i) / (eta * eta));
  return d / eta + normal * (cos_i / eta - cos_t);
}

constexpr double kIncidence_deg = 49.3233;  // least deviation at 587.6 nm
const Vec3d kTowardsPrism = direction_at(kEntry_deg + 180 + kIncidence_deg);

Vec3d direction_behind_prism(double nm) {
  const double n = index_of_bk7(nm);
  const Vec3d within = refracted(kTowardsPrism, direction_at(kEntry_deg), n);
  return refracted(within, -direction_at(kExit_deg), 1 / n);
}

double deviation_deg(double nm) {
  return std::acos(dot(kTowardsPrism, direction_behind_prism(nm))) / kRadians;
}

const Vec3d kEntry = direction_at(kEntry_deg) * kHalfFace;
const Vec3d kExit = direction_at(kExit_deg) * kHalfFace;

// The image is a strip of a screen 4 m behind the prism, 160 by 16 pixels of 0.8 mm. Pixels of the prism
// scene of the suite, 512 pixels high, are four times as wide: half of one is 1.6 mm.
constexpr double kPixel = 0.0008;
constexpr double kHalfPixelOfSuite = 0.0016;
constexpr int kHeight = 16;
const Vec3d kScreen = direction_behind_prism(540) * 4;

// Where a ray of this wavelength, from the light through the middle of the entry, hits the screen, measured
// from its centre to the right.
double spot(double nm) {
  const Vec3d within = refracted(kTowardsPrism, direction_at(kEntry_deg), index_of_bk7(nm));
  const Vec3d left = kEntry + within * (dot(kExit - kEntry, kExit) / dot(within, kExit));
  const Vec3d d = direction_behind_prism(nm);
  const Vec3d met = left + d * (dot(kScreen - left, kScreen) / dot(d, kScreen));
  return dot(met - kScreen, normalised(cross(kScreen, {0, 0, 1})));
}

// A black wall in front of the prism with a slightly larger hole: squares on all four sides of it.
std::vector<std::string> wall() {
  constexpr double kHalfSquare = 2;
  const Vec3d hole = kEntry - kTowardsPrism * 0.01;
  const Vec3d up = cross({0, 0, 1}, kTowardsPrism);
  std::vector<std::string> squares;
  for (const Vec3d side : {up, -up, Vec3d{0, 0, 1}, Vec3d{0, 0, -1}})
    squares.push_back(
        square(hole + side * (kHalfSquare + 1.2 * kHalfFace), kTowardsPrism, kHalfSquare, "black"));
  return squares;
}

// A light that emits in a band of 4 nm around `nm`.
image::Image prism_image(double nm) {
  const Vec3d eye = kScreen * 0.75 + Vec3d{0, 0, 0.2};
  const View view{.position = text_of(eye),
                  .look_at = text_of(kScreen),
                  .up = "[0, 0, 1]",
                  .fov_deg = 2 * std::atan(kHeight / 2 * kPixel / length(kScreen - eye)) / kRadians,
                  .width = 160,
                  .height = kHeight};
  auto squares = wall();
  squares.push_back(square(kEntry, kEntry, kHalfFace, "glass"));
  squares.push_back(square(kExit, kExit, kHalfFace, "glass"));
  squares.push_back(square(kScreen, -kScreen, 0.3, "screen"));
  const auto text = scene_of(
      view,
      fmt::format(
          R"("spectra": [{{"name": "line", "wavelengths": [{}, {}, {}], "values": [0, 1000, 0], "beyond": "zero"}}], )"
          R"("materials": [{{"name": "glass", "type": "dielectric", )"
          R"("index": {{"file": "data/common/spectra/glasses_sellmeier.csv", "material": "BK7"}}}}, )"
          R"({{"name": "black", "type": "lambert", "reflectance": [0, 0, 0]}}, )"
          R"({{"name": "screen", "type": "lambert", "reflectance": [1, 1, 1]}}], {}, )"
          R"("lights": [{{"type": "sphere", "radius": 0.0005, "radiance": {{"spectrum": "line"}}, )"
          R"("matrix": [{{"translate": {}}}]}}])",
          nm - 2, nm, nm + 2, meshes(squares), text_of(kEntry - kTowardsPrism * 2)));
  return image_of(text, 128);
}

// On the screen, as spot(). By luminance, because a single wavelength makes some channel negative.
double centre_of_light(const image::Image& image) {
  double sum = 0;
  double moment = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const double light = luminance_by_sum({image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)});
      sum += light;
      moment += light * (x + 0.5);
    }
  return (moment / sum - 0.5 * image.width) * kPixel;
}

}  // namespace

// Independent numbers.
TEST(Dispersion, SnellsLawHasTheKnownDeviations) {
  EXPECT_NEAR(deviation_deg(404.6561), 39.840987, 1e-5);
  EXPECT_NEAR(deviation_deg(587.5618), 38.646699, 1e-5);
  EXPECT_NEAR(deviation_deg(706.5188), 38.304248, 1e-5);
}

TEST(Dispersion, APrismSendsEachWavelengthWhereSnellsLawDoes) {
  for (const double nm : {435.8, 486.1, 546.1, 587.6, 656.3}) {
    const double found = centre_of_light(prism_image(nm));
    EXPECT_NEAR(found, spot(nm), kHalfPixelOfSuite) << nm;
    RecordProperty(fmt::format("off_by_pixels_{}", std::lround(nm)),
                   fmt::format("{:.3f}", (found - spot(nm)) / (2 * kHalfPixelOfSuite)));
  }
}

namespace {

// A ball of BK7 above a floor, straight below a small light, as in caustic_BK7 of the suite.
constexpr double kBallHeight = 1.28;
constexpr double kLampHeight = 6.3;
constexpr double kCausticPixel = 0.001;  // on the floor, across; a fold moves by 8.6 mm from 436 to 656 nm

// Distance from the axis at which light reaches the floor that hits the ball at `angle` from its top.
double landing(double angle, double n) {
  const Vec3d entry = direction_at(90 - angle / kRadians);  // x across, y up; the ball's centre is the origin
  const Vec3d within = refracted(normalised(entry - Vec3d{0, kLampHeight - kBallHeight, 0}), entry, n);
  const Vec3d exit = entry - within * (2 * dot(entry, within));
  const Vec3d d = refracted(within, -exit, 1 / n);
  return exit.x - d.x * (kBallHeight + exit.y) / d.y;
}

// The fold of the caustic: the first maximum of that distance from the axis outwards, by trisection.
double fold(double nm) {
  const double n = index_of_bk7(nm);
  double low = 0.1;
  double high = 0.8;
  while (high - low > 1e-9) {
    const double third = (high - low) / 3;
    if (landing(low + third, n) < landing(high - third, n))
      low += third;
    else
      high -= third;
  }
  return landing(low, n);
}

// A strip of the floor around the fold of 546 nm, from the axis outwards. The ball has a single index, that
// of BK7 at `nm`, because few wavelengths of a path would lie in a narrow band.
image::Image caustic_image(double nm) {
  const Vec3d middle{fold(546), 0, 0};
  const Vec3d eye = middle + Vec3d{0, 3, 4.5};  // sees the floor under the ball
  constexpr int kRows = 6;
  const View view{.position = text_of(eye),
                  .look_at = text_of(middle),
                  .fov_deg = 2 * std::atan(kRows / 2.0 * kCausticPixel / length(middle - eye)) / kRadians,
                  .width = 64,
                  .height = kRows};
  return image_of(
      scene_of(
          view,
          fmt::format(
              R"("materials": [{{"name": "glass", "type": "dielectric", "index": {:.17g}}}, )"
              R"({{"name": "floor", "type": "lambert", "reflectance": [0.8, 0.8, 0.8]}}], {}, )"
              R"("shapes": [{{"type": "sphere", "centre": [0, {}, 0], "radius": 1, "material": "glass"}}], )"
              R"("lights": [{{"type": "rect", "half_width": 0.0005, "half_length": 0.0005, )"
              R"("radiance": [1000000, 1000000, 1000000], "matrix": [{{"translate": [0, {}, 0]}}]}}])",
              index_of_bk7(nm), meshes({square({0, 0, 0}, {0, 1, 0}, 5, "floor")}), kBallHeight,
              kLampHeight)),
      1024);
}

// The middle of the outermost column that is at least half as bright as the brightest, from the axis. The
// irradiance at a fold is 1 / sqrt(distance) inside and zero outside (Berry and Upstill 1980, sec. 2).
double rim_of(const image::Image& image) {
  std::vector<double> columns(static_cast<std::size_t>(image.width));
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      columns[static_cast<std::size_t>(x)] += static_cast<double>(image.at(x, y, 0));
  const double half = *std::max_element(columns.begin(), columns.end()) / 2;
  const auto from_right =
      std::find_if(columns.rbegin(), columns.rend(), [&](double c) { return c >= half; }) - columns.rbegin();
  return fold(546) +
         (static_cast<double>(image.width) / 2 - static_cast<double>(from_right) - 0.5) * kCausticPixel;
}

}  // namespace

TEST(Dispersion, TheCausticOfABallEndsWhereSnellsLawFoldsIt) {
  EXPECT_NEAR(fold(656.3) - fold(435.8), 0.0086, 5e-5);
  for (const double nm : {435.8, 486.1, 546.1, 587.6, 656.3})
    EXPECT_NEAR(rim_of(caustic_image(nm)), fold(nm), kCausticPixel) << nm;
}

namespace {

// A ball in a uniform environment with a light beside it, in spectral light whatever the ball is.
image::Image ball_of(const std::string& material) {
  return image_of(
      scene_of(
          {.position = "[0, 1, 5]", .fov_deg = 30, .width = 24, .height = 24},
          R"("environment": [1, 1, 1], "materials": [{"name": "ball", )" + material +
              R"(}, {"name": "floor", "type": "lambert", "reflectance": [0.7, 0.7, 0.7]}], )"
              R"("shapes": [{"type": "sphere", "centre": [0, 0, 0], "radius": 1, "material": "ball"}], )" +
              meshes({square({0, -1, 0}, {0, 1, 0}, 5, "floor")}),
          "8"),
      32, {.transport = scene::LightTransport::Spectral});
}

double mean_variance(const image::Image& image) {
  return (mean_of(image, "variance.R") + mean_of(image, "variance.G") + mean_of(image, "variance.B")) / 3;
}

}  // namespace

// An index without wavelengths, one that is constant over a table, and the glass of ORB.S.
TEST(Dispersion, AConstantIndexCostsNoNoise) {
  const auto achromatic = ball_of(R"("type": "glass", "ior": 1.5)");
  const auto constant = ball_of(R"("type": "dielectric", "index": 1.5)");
  const auto table =
      ball_of(R"("type": "dielectric", "index": {"wavelengths": [400, 700], "values": [1.5, 1.5]})");
  EXPECT_EQ(table.pixels, constant.pixels);
  EXPECT_NEAR(mean_variance(constant) / mean_variance(achromatic), 1, 0.05);
  const auto dispersive = ball_of(R"("type": "dielectric", "index": {"cauchy": [1.4847, 0.0042]})");
  EXPECT_GT(mean_variance(dispersive), 3 * mean_variance(constant));
  for (std::size_t channel = 0; channel < 3; ++channel)
    EXPECT_NEAR(mean_of_channel(dispersive, channel), mean_of_channel(constant, channel),
                4 * std::hypot(error_of_mean(dispersive, channel), error_of_mean(constant, channel)) + 1e-3);
}

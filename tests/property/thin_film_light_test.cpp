// Reflectances of films as paths evaluate them, in float, against characteristic matrices in double.
#include "property/light_images.h"
#include "property/light_quadrature.h"
#include "tracer/bsdf/boundary.h"

#include <numbers>

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using Complex = std::complex<double>;

// A film of real index between two media; the base may absorb.
struct Stack {
  double outside = 1;
  double film = 1;
  double height_nm = 0;
  Complex base = 1;
};

// Normal component of the wave vector divided by its length in vacuum.
Complex normal_component(Complex index, double across) {
  const Complex root = std::sqrt(index * index - across * across);
  return root.imag() < 0 ? -root : root;
}

// The characteristic matrix of the film gives the fields at its top from those at its base, and their
// admittance gives the reflected amplitude (Macleod, "Thin-Film Optical Filters", 4th edition, eq. 2.88
// to 2.98). It uses neither a sum over reflections nor a Fresnel equation.
double reflectance_by_matrix(const Stack& stack, double cos_i, double nm) {
  const double across = stack.outside * std::sqrt(1 - cos_i * cos_i);
  double sum = 0;
  for (const bool is_p : {false, true}) {
    const auto admittance = [&](Complex index) {
      const Complex normal = normal_component(index, across);
      return is_p ? index * index / normal : normal;
    };
    const Complex phase = 2 * std::numbers::pi * stack.height_nm / nm * normal_component(stack.film, across);
    const Complex film = admittance(stack.film);
    const Complex base = admittance(stack.base);
    const Complex i(0, 1);
    const Complex electric = std::cos(phase) - i * std::sin(phase) / film * base;
    const Complex magnetic = -i * std::sin(phase) * film + std::cos(phase) * base;
    const Complex outside = admittance(stack.outside);
    sum += std::norm((outside * electric - magnetic) / (outside * electric + magnetic));
  }
  return sum / 2;
}

constexpr std::array<float, 5> kDegrees{0, 30, 45, 60, 80};
constexpr std::array<std::array<float, 4>, 2> kWavelengths{{{400, 450, 500, 550}, {600, 650, 700, 780}}};

// Largest difference between a path at four wavelengths and the stack, over 5 angles and 8 wavelengths.
double largest_difference(const Stack& stack) {
  double largest = 0;
  for (const auto& nm : kWavelengths) {
    const scene::Film film{spectra::constant(stack.film), stack.height_nm};
    const spectra::MetalIndex metal{spectra::constant(stack.base.real()),
                                    spectra::constant(stack.base.imag())};
    const auto boundary = tracer::boundary_between<4>(nm, spectra::constant(stack.outside), metal, film);
    for (const float degrees : kDegrees) {
      const float cos_i = std::cos(degrees * std::numbers::pi_v<float> / 180);
      const auto found = tracer::reflectances(boundary, cos_i);
      for (std::size_t i = 0; i < 4; ++i)
        largest = std::max(largest, std::abs(static_cast<double>(found[i]) -
                                             reflectance_by_matrix(stack, static_cast<double>(cos_i),
                                                                   static_cast<double>(nm[i]))));
    }
  }
  return largest;
}

void expect_reflectances(const std::string& name, const Stack& stack) {
  const double difference = largest_difference(stack);
  EXPECT_LT(difference, 1e-5) << name;
  testing::Test::RecordProperty(name, fmt::format("{:.1e}", difference));
}

}  // namespace

// Independent numbers: a soap film in air, and a quarter wave of magnesium fluoride on glass at 550 nm.
TEST(ThinFilmLight, TheMatrixHasTheKnownReflectancesAtNormalIncidence) {
  EXPECT_NEAR(reflectance_by_matrix({1, 1.33, 300, 1}, 1, 550), 0.07543020, 1e-8);
  EXPECT_NEAR(reflectance_by_matrix({1, 1.38, 550 / (4 * 1.38), 1.52}, 1, 550), 0.01260079, 1e-8);
  EXPECT_NEAR(reflectance_by_matrix({1, 1.38, 550 / (4 * 1.38), 1.52}, 1, 400), 0.02205252, 1e-8);
  EXPECT_NEAR(reflectance_by_matrix({1, 2.4, 100, 1.5}, 1, 600), 0.17265815, 1e-8);
}

TEST(ThinFilmLight, FilmsReflectByAirysSumAtFiveAnglesAndEightWavelengths) {
  expect_reflectances("on_aluminium", {1, 1.5, 400, {1.1, 6.9}});
  expect_reflectances("on_silver", {1, 2.2, 250, {0.05, 3.9}});
  expect_reflectances("on_glass", {1, 1.38, 100, 1.52});
  expect_reflectances("on_glass_thick", {1, 2.4, 1200, 1.5});
  expect_reflectances("on_glass_in_water", {1.33, 1.8, 500, 1.52});
  expect_reflectances("on_metal_in_oil", {1.5, 1.3, 300, {2.9, 3.0}});
}

// From inside the glass, with total reflection beyond some angles, through films with propagating or
// evanescent waves.
TEST(ThinFilmLight, FilmsReflectByAirysSumFromWithin) {
  expect_reflectances("glass_to_air", {1.52, 1.38, 100, 1});
  expect_reflectances("glass_to_air_dense_film", {1.5, 2.4, 150, 1});
  expect_reflectances("glass_to_air_thick", {1.5, 1.33, 800, 1});
  expect_reflectances("glass_to_water", {1.52, 1.8, 500, 1.33});
}

// Such a film changes no wavelength.
TEST(ThinFilmLight, AFilmOfTheBasesIndexChangesNothing) {
  const spectra::RefractiveIndex glass = spectra::constant(1.5);
  const spectra::RefractiveIndex air = spectra::constant(1);
  const auto with = tracer::boundary_between<4>(kWavelengths[0], air, glass, scene::Film{glass, 300});
  const auto without = tracer::boundary_between<4>(kWavelengths[0], air, glass, std::nullopt);
  for (const float cos_i : {1.0F, 0.7F, 0.2F})
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(tracer::reflectances(with, cos_i)[i], tracer::reflectances(without, cos_i)[i], 1e-6);
}

namespace {

// A smooth material in a D65 environment, seen at 60 degrees from the normal.
void expect_colour_at_60_degrees(const std::string& material, const tests::OfWavelength& reflectance) {
  const auto text =
      tests::scene_of({.position = "[8.660254037844386, 0, 5]"},
                      R"("environment": [1, 1, 1], "materials": [{"name": "m", )" + material + "}], " +
                          tests::meshes({tests::square({0, 0, 0}, {0, 0, 1}, 1, "m")}));
  const auto image = tests::image_of(text, 256);
  const auto d65 = tests::illuminant_by_table("D65");
  const Vec3d expected = tests::rgb_by_sum([&](double nm) { return d65(nm) * reflectance(nm); });
  const std::array<double, 3> channels{expected.x, expected.y, expected.z};
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const double error = tests::error_of_mean(image, channel);
    EXPECT_NEAR(tests::mean_of_channel(image, channel), channels[channel], 4 * error + 1e-5)
        << material << " channel " << channel;
    EXPECT_LT(error, 0.003);
  }
}

}  // namespace

// Interference and metals in the image: the integral of each wavelength's own reflectance.
TEST(ThinFilmLight, FilmsAndMetalsHaveTheirColours) {
  expect_colour_at_60_degrees(
      R"("type": "conductor", "index": {"n": 1.1, "k": 6.9}, "film": {"index": 1.5, "height_nm": 400})",
      [](double nm) {
        return reflectance_by_matrix({1, 1.5, 400, {1.1, 6.9}}, 0.5, nm);
      });
  const auto n = tests::table_column("metals/copper.csv", "n", true);
  const auto k = tests::table_column("metals/copper.csv", "k", true);
  expect_colour_at_60_degrees(
      R"("type": "conductor", "index": {"file": "data/common/spectra/metals/copper.csv"})", [&](double nm) {
        return reflectance_by_matrix({1, 1, 0, {n(nm), k(nm)}}, 0.5, nm);
      });
}

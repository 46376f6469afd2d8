#include "snippets/fresnel_mueller.h"

#include "base/random.h"

#include <numbers>

#include <gtest/gtest.h>

namespace {

using namespace snippets;
using Complex = std::complex<double>;
constexpr Complex kI{0, 1};
constexpr double kPi = std::numbers::pi;
constexpr Stokes<double> kUnpolarised{1, 0, 0, 0};

double cos_deg(double degrees) { return std::cos(degrees * (kPi / 180)); }

double reflectance_s(double degrees, double n) {
  return std::norm(fresnel_reflection(cos_deg(degrees), Complex(n)).s);
}
double reflectance_p(double degrees, double n) {
  return std::norm(fresnel_reflection(cos_deg(degrees), Complex(n)).p);
}

double random_number(std::uint64_t i, std::uint64_t dimension) {
  return orbs::unit_random(orbs::mix(i, dimension));
}

// Light of any degree of polarisation up to 1.
Stokes<double> random_light(std::uint64_t i) {
  const double z = 2 * random_number(i, 1) - 1;
  const double phi = 2 * kPi * random_number(i, 2);
  const double degree = i % 3 == 0 ? 1 : random_number(i, 3);
  const double across = degree * std::sqrt(1 - z * z);
  return {1, across * std::cos(phi), across * std::sin(phi), degree * z};
}

// Any of the elements of this file, turned anyhow.
Mueller<double> random_element(std::uint64_t i) {
  const double cos_i = random_number(i, 11);
  const double n = 0.4 + 2.6 * random_number(i, 12);
  const std::array elements{reflection_mueller(cos_i, Complex(n)),
                            reflection_mueller(cos_i, Complex(n, 5 * random_number(i, 13))),
                            transmission_mueller(cos_i, n), polariser_along_x<double>(),
                            retarder_fast_along_x(7 * random_number(i, 14))};
  return turned(elements[i % elements.size()], frame_turn(7 * random_number(i, 15)));
}

}  // namespace

TEST(FresnelMueller, DielectricsReflectWhatFresnelSays) {
  struct Row {
    double degrees, s, p;
  };
  for (const auto& [degrees, s, p] :
       {Row{0, 0.04, 0.04}, Row{30, 0.057796, 0.025249}, Row{45, 0.092013, 0.008466},
        Row{60, 0.176571, 0.001802}, Row{75, 0.399356, 0.106765}}) {
    EXPECT_NEAR(reflectance_s(degrees, 1.5), s, 5e-7);
    EXPECT_NEAR(reflectance_p(degrees, 1.5), p, 5e-7);
  }
}

// ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2).
TEST(FresnelMueller, MetalsReflectWhatFresnelSaysAtNormalIncidence) {
  EXPECT_NEAR(reflection_mueller(1.0, Complex(0.2, 3.4)).mean, 0.93846154, 5e-9);
  EXPECT_NEAR(reflection_mueller(1.0, Complex(1.1, 6.9)).mean, 0.91541715, 5e-9);
  EXPECT_NEAR(reflection_mueller(1.0, Complex(2.9, 3.0)).mean, 0.52085915, 5e-9);
}

// At tan(i) = n nothing polarised in the plane of incidence is reflected; across it ((n^2 - 1) / (n^2 +
// 1))^2.
TEST(FresnelMueller, TheBrewsterReflectionIsExtinctBehindTheCrossedPolariser) {
  for (const double n : {1.33, 1.5, 1.52, 2.417}) {
    const double cos_i = 1 / std::sqrt(1 + n * n);
    const auto reflected = reflection_mueller(cos_i, Complex(n)) * kUnpolarised;
    const double s = std::pow((n * n - 1) / (n * n + 1), 2);
    EXPECT_NEAR(reflected[0], s / 2, 1e-15);
    EXPECT_NEAR(degree_of_polarisation(reflected), 1, 1e-12);
    EXPECT_NEAR((polariser_along_x<double>() * reflected)[0], s / 2, 1e-15);
    EXPECT_LT((polariser_along_x<double>() * (frame_turn(kPi / 2) * reflected))[0], 1e-15);
    const auto in_float =
        reflection_mueller(static_cast<float>(cos_i), std::complex<float>(static_cast<float>(n)));
    EXPECT_LT(in_float.mean - in_float.half, 1e-6F);
  }
}

TEST(FresnelMueller, TwoBrewsterMirrorsPassTheSquareOrNothing) {
  const auto mirror = reflection_mueller(1 / std::sqrt(3.25), Complex(1.5));
  const auto once = mirror * kUnpolarised;
  EXPECT_NEAR((mirror * once)[0], 0.01094149, 5e-9);
  EXPECT_NEAR((mirror * (frame_turn(kPi / 2) * once))[0], 0, 1e-16);
}

TEST(FresnelMueller, MalusAtSevenAngles) {
  const auto behind_first = polariser_along_x<double>() * kUnpolarised;
  for (const double degrees : {0, 15, 30, 45, 60, 75, 90}) {
    const auto second = turned(polariser_along_x<double>(), frame_turn(degrees * kPi / 180));
    EXPECT_NEAR((second * behind_first)[0], 0.5 * cos_deg(degrees) * cos_deg(degrees), 1e-15) << degrees;
  }
}

// N polarisers fanned over 90 degrees pass cos^{2 (N - 1)}(90 / (N - 1)) / 2.
TEST(FresnelMueller, AFanOfPolarisersTurnsTheLight) {
  for (const auto& [count, passed] :
       {std::pair{3, 0.125}, std::pair{5, 0.26539502}, std::pair{91, 0.48647774}}) {
    Stokes<double> light = polariser_along_x<double>() * kUnpolarised;
    for (int i = 1; i < count; ++i)
      light = polariser_along_x<double>() * (frame_turn(kPi / 2 / (count - 1)) * light);
    EXPECT_NEAR(light[0], passed, 5e-9) << count;
  }
}

// All orders of reflection inside, summed: T = (1 - R) / (1 + R) for each polarisation.
TEST(FresnelMueller, AGlassSlabTransmitsEachPolarisationByItsOwnSeries) {
  for (const auto& [degrees, mean] :
       {std::pair{0.0, 0.923077}, std::pair{30.0, 0.920734}, std::pair{45.0, 0.907344},
        std::pair{56.309932, 0.871134}, std::pair{60.0, 0.848128}, std::pair{75.0, 0.618149},
        std::pair{85.0, 0.246931}}) {
    const double cos_i = cos_deg(degrees);
    const double cos_t = std::sqrt(1 - (1 - cos_i * cos_i) / 2.25);
    const auto inside = reflection_mueller(cos_t, Complex(1 / 1.5));
    const auto out = transmission_mueller(cos_t, 1 / 1.5);
    Stokes<double> within = transmission_mueller(cos_i, 1.5) * kUnpolarised;
    Stokes<double> passed{};
    for (int order = 0; order < 400; ++order) {
      const auto leaves = out * within;
      for (std::size_t i = 0; i < 4; ++i) passed[i] += leaves[i];
      within = inside * (inside * within);
    }
    EXPECT_NEAR(passed[0], mean, 6e-7) << degrees;
    const double s = reflectance_s(degrees, 1.5);
    const double p = reflectance_p(degrees, 1.5);
    EXPECT_NEAR(passed[0] + passed[1], (1 - s) / (1 + s), 1e-12) << degrees;
    EXPECT_NEAR(passed[0] - passed[1], (1 - p) / (1 + p), 1e-12) << degrees;
  }
}

TEST(FresnelMueller, ReflectionAndTransmissionShareTheLightOfEachPolarisation) {
  for (const double n : {0.3, 1 / 1.5, 0.99, 1.0, 1.33, 2.417})
    for (double cos_i = 0.01; cos_i <= 1; cos_i += 0.011) {
      const auto r = reflection_mueller(cos_i, Complex(n));
      const auto t = transmission_mueller(cos_i, n);
      EXPECT_NEAR(r.mean + t.mean, 1, 1e-12) << n << " " << cos_i;
      EXPECT_NEAR(r.half + t.half, 0, 1e-12) << n << " " << cos_i;
    }
}

// tan(d / 2) = cos i sqrt(sin^2 i - n^2) / sin^2 i (Born and Wolf 1.5.4 eq. 61): Fresnel's rhomb, two
// reflections in glass of 1.51 at 54 degrees 37 minutes, delays by a quarter wave.
TEST(FresnelMueller, TotalReflectionDelaysOnePolarisation) {
  const double n = 1 / 1.51;
  for (const double degrees : {45.0, 48.624, 54.616, 70.0}) {
    const double c = cos_deg(degrees);
    const double s2 = 1 - c * c;
    const auto r = reflection_mueller(c, Complex(n));
    EXPECT_NEAR(r.mean, 1, 1e-14);
    EXPECT_NEAR(r.half, 0, 1e-14);
    const double retardance = 2 * std::atan(c * std::sqrt(s2 - n * n) / s2);
    EXPECT_NEAR(r.real, -std::cos(retardance - kPi), 1e-12);
    EXPECT_NEAR(std::atan2(r.imaginary, r.real), retardance, 1e-12);
  }
  const auto rhomb = reflection_mueller(cos_deg(54.616), Complex(n));
  const auto circular = rhomb * (rhomb * Stokes<double>{1, 0, 1, 0});
  EXPECT_NEAR(std::abs(circular[3]), 1, 1e-4);
}

// Right-circular light turns clockwise for who looks at it, x to the right and y up; a field that falls
// behind along y by a quarter turn does the opposite.
TEST(FresnelMueller, SignsAreTheStatedOnes) {
  const Complex x = 1;
  const Complex y = -kI;
  EXPECT_GT((2.0 * x * std::conj(y)).imag(), 0);  // S3
  const auto field = [&](double wt) {
    const Complex turn = std::exp(-kI * wt);
    return std::pair{(x * turn).real(), (y * turn).real()};
  };
  EXPECT_NEAR(field(0).first, 1, 1e-15);
  EXPECT_NEAR(field(kPi / 2).second, -1, 1e-15);  // from right to down: clockwise
  const auto quarter = retarder_fast_along_x(kPi / 2);
  EXPECT_NEAR((quarter * Stokes<double>{1, 0, 1, 0})[3], -1, 1e-15);
  const auto same = aligned_mueller(Complex(1), std::exp(kI * (kPi / 2)));
  EXPECT_NEAR(same.imaginary, quarter.imaginary, 1e-15);
  const auto mirror = reflection_mueller(1.0, Complex(0.2, 3.4)) * Stokes<double>{1, 0, 0, 1};
  EXPECT_NEAR(mirror[3] / mirror[0], -1, 1e-14) << "a mirror makes left of right";
  const auto slanted = frame_turn(kPi / 4) * Stokes<double>{1, 0, 1, 0};
  EXPECT_NEAR(slanted[1], 1, 1e-15) << "+45 degree light lies along x of a frame turned by 45 degrees";
}

TEST(FresnelMueller, FramesTurnByTheAngleBetweenTheirReferenceDirections) {
  struct Vector {
    double x, y, z;
  };
  for (const double angle : {-2.0, -0.3, 0.0, 0.7, 1.9}) {
    const auto expected = frame_turn(angle);
    const auto up =
        frame_turn_between(Vector{1, 0, 0}, Vector{std::cos(angle), std::sin(angle), 0}, Vector{0, 0, 1});
    const auto down =
        frame_turn_between(Vector{1, 0, 0}, Vector{std::cos(angle), std::sin(angle), 0}, Vector{0, 0, -1});
    EXPECT_NEAR(up.cos2, expected.cos2, 1e-15);
    EXPECT_NEAR(up.sin2, expected.sin2, 1e-15);
    EXPECT_NEAR(down.sin2, -expected.sin2, 1e-15);
  }
}

TEST(FresnelMueller, ElementsNeverMakeLightOrPolariseItMoreThanFully) {
  for (std::uint64_t i = 0; i < 20000; ++i) {
    Stokes<double> light = random_light(i);
    for (std::uint64_t step = 0; step < 4; ++step) {
      const double before = light[0];
      light = random_element(5 * i + step) * light;
      ASSERT_LE(light[0], before * (1 + 1e-12));
      ASSERT_GE(light[0], -1e-15);
      if (light[0] < 1e-9) break;
      ASSERT_LE(degree_of_polarisation(light), 1 + 1e-6) << i;
    }
  }
}

// (row M) S = row (M S), whichever form M has.
TEST(FresnelMueller, RowsFromTheCameraAgreeWithColumnsFromTheLight) {
  const auto product = [](const Stokes<double>& row, const Stokes<double>& s) {
    return row[0] * s[0] + row[1] * s[1] + row[2] * s[2] + row[3] * s[3];
  };
  for (std::uint64_t i = 0; i < 200; ++i) {
    const Stokes<double> row = random_light(i);
    const Stokes<double> light = random_light(1000 + i);
    const auto surface = reflection_mueller(random_number(i, 4), Complex(1.3, random_number(i, 5)));
    const auto turn = frame_turn(6 * random_number(i, 6));
    EXPECT_NEAR(product(row_times(row, surface), light), product(row, surface * light), 1e-14);
    EXPECT_NEAR(product(row_times(row, turn), light), product(row, turn * light), 1e-14);
    const auto both = full(surface) * full(turn);
    EXPECT_NEAR(product(row_times(row, both), light), product(row, surface * (turn * light)), 1e-14);
    EXPECT_NEAR(product(row, both * light), product(row, surface * (turn * light)), 1e-14);
  }
}

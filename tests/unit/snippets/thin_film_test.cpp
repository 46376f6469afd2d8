#include "snippets/thin_film.h"

#include "snippets/fresnel_mueller.h"

#include <array>
#include <vector>

#include <gtest/gtest.h>

namespace {

using namespace snippets;
using Complex = std::complex<double>;
using Film = ThinFilm<double>;
constexpr Complex kI{0, 1};
constexpr double kPi = std::numbers::pi;

const std::array kAngles_deg{0.0, 20.0, 40.0, 60.0, 80.0};
const std::array kWavelengths_nm{400.0, 450.0, 500.0, 550.0, 600.0, 650.0, 700.0, 750.0};

// Metals and dielectrics, films above and below them in index, an absorbing film, and an air gap in glass.
const std::vector<Film> kFilms{{1, 1.2, {1.9, 1.5}, 550},      {1, 1.5, {1.9, 1.5}, 550},
                               {1, 2.8, {1.9, 1.5}, 550},      {1, 1.33, {1.9, 1.5}, 1500},
                               {1, 1.33, {0.25, 3.0}, 550},    {1, 1.33, 1.0, 300},
                               {1, 1.38, 1.52, 99.6377},       {1, 2.4, 1.5, 100},
                               {1.33, {1.6, 0.2}, {2, 1}, 80}, {1.5, 1.0, 1.5, 120}};

double cos_deg(double degrees) { return std::cos(degrees * (kPi / 180)); }

// The second way: fields along the surface, carried through the film by its characteristic matrix (Abeles;
// Born and Wolf 1.6.2), and matched outside.
struct Fields {
  Complex reflected;
  Complex transmitted;
};
Fields by_characteristic_matrix(Complex outside, Complex film, Complex base, Complex phase) {
  const Complex e = std::cos(phase) - kI * std::sin(phase) * base / film;
  const Complex h = base * std::cos(phase) - kI * film * std::sin(phase);
  return {(outside * e - h) / (outside * e + h), 2.0 * outside / (outside * e + h)};
}

struct BothFields {
  Fields s;
  Fields p;
  double outside_s;
  double outside_p;
  double base_s;
  double base_p;
};
BothFields second_way(const Film& film, double degrees, double wavelength_nm) {
  const double across = film.outside_index * std::sin(degrees * kPi / 180);
  const Complex outside = film.outside_index * cos_deg(degrees);
  const Complex inside = std::sqrt(film.film_index * film.film_index - across * across);
  const Complex base = std::sqrt(film.base_index * film.base_index - across * across);
  const Complex phase = 2 * kPi * film.height_nm / wavelength_nm * inside;
  const Complex outside_p = film.outside_index * film.outside_index / outside;
  const Complex base_p = film.base_index * film.base_index / base;
  return {by_characteristic_matrix(outside, inside, base, phase),
          by_characteristic_matrix(outside_p, film.film_index * film.film_index / inside, base_p, phase),
          outside.real(),
          outside_p.real(),
          base.real(),
          base_p.real()};
}

template <typename F>
void for_each_setting(const F& f) {
  for (const Film& film : kFilms)
    for (const double degrees : kAngles_deg)
      for (const double nm : kWavelengths_nm) f(film, degrees, nm);
}

}  // namespace

// Soap in air, 300 nm; a quarter wave (at 550 nm) of MgF2 on glass; a high film on glass.
TEST(ThinFilm, NormalIncidenceHasItsTable) {
  const std::array films{Film{1, 1.33, 1.0, 300}, Film{1, 1.38, 1.52, 550 / (4 * 1.38)},
                         Film{1, 2.4, 1.5, 100}};
  const std::array<std::array<double, 4>, 7> table{{{400, 0.00002061, 0.02205252, 0.17265815},
                                                    {450, 0.03444599, 0.01620430, 0.05888053},
                                                    {500, 0.07079029, 0.01335683, 0.04694801},
                                                    {550, 0.07543020, 0.01260079, 0.10307670},
                                                    {600, 0.05829576, 0.01312726, 0.17265815},
                                                    {650, 0.03469435, 0.01436835, 0.23129802},
                                                    {700, 0.01492163, 0.01596197, 0.27451431}}};
  for (const auto& row : table)
    for (std::size_t i = 0; i < films.size(); ++i)
      EXPECT_NEAR(film_reflectance(films[i], 1.0, row[0]), row[i + 1], 6e-9) << row[0] << " nm, film " << i;
}

TEST(ThinFilm, AiryAgreesWithTheCharacteristicMatrixInAmplitudeAndPhase) {
  for_each_setting([](const Film& film, double degrees, double nm) {
    const auto r = film_reflection(film, cos_deg(degrees), nm);
    const BothFields expected = second_way(film, degrees, nm);
    EXPECT_LT(std::abs(r.s - expected.s.reflected), 1e-12) << degrees << " " << nm;
    EXPECT_LT(std::abs(r.p + expected.p.reflected), 1e-12)
        << degrees << " " << nm;  // r_p = -r_s: see the signs
  });
}

TEST(ThinFilm, FloatsReachOneInAHundredThousand) {
  for_each_setting([](const Film& film, double degrees, double nm) {
    const ThinFilm<float> in_float{static_cast<float>(film.outside_index),
                                   std::complex<float>(film.film_index), std::complex<float>(film.base_index),
                                   static_cast<float>(film.height_nm)};
    const double expected = film_reflectance(film, cos_deg(degrees), nm);
    EXPECT_NEAR(film_reflectance(in_float, static_cast<float>(cos_deg(degrees)), static_cast<float>(nm)),
                expected, 1e-5);
  });
}

TEST(ThinFilm, WithoutHeightItIsTheBareSurface) {
  for (const Complex base : {Complex(1.9, 1.5), Complex(1.52)})
    for (const double degrees : kAngles_deg) {
      const auto film = film_reflection(Film{1, 1.7, base, 0}, cos_deg(degrees), 500.0);
      const auto bare = fresnel_reflection(cos_deg(degrees), base);
      EXPECT_LT(std::abs(film.s - bare.s), 1e-14);
      EXPECT_LT(std::abs(film.p - bare.p), 1e-14);
    }
}

// Half a wave is invisible; a quarter of one reflects ((n1 n3 - n2^2) / (n1 n3 + n2^2))^2.
TEST(ThinFilm, HalfAndQuarterWavesHaveTheirClosedForms) {
  EXPECT_NEAR(film_reflectance(Film{1, 1.38, 1.52, 550 / (2 * 1.38)}, 1.0, 550.0), std::pow(0.52 / 2.52, 2),
              1e-14);
  const double n2 = 1.38 * 1.38;
  EXPECT_NEAR(film_reflectance(Film{1, 1.38, 1.52, 550 / (4 * 1.38)}, 1.0, 550.0),
              std::pow((1.52 - n2) / (1.52 + n2), 2), 1e-14);
}

TEST(ThinFilm, TransmissionIsWhatADielectricDoesNotReflect) {
  for_each_setting([](const Film& film, double degrees, double nm) {
    if (film.base_index.imag() != 0 || film.film_index.imag() != 0) return;
    const auto r = film_reflection(film, cos_deg(degrees), nm);
    const auto t = film_transmission(film, cos_deg(degrees), nm);
    EXPECT_NEAR(std::norm(r.s) + std::norm(t.s), 1, 1e-12) << degrees << " " << nm;
    EXPECT_NEAR(std::norm(r.p) + std::norm(t.p), 1, 1e-12) << degrees << " " << nm;
    const BothFields expected = second_way(film, degrees, nm);
    EXPECT_LT(std::abs(t.s - expected.s.transmitted * std::sqrt(expected.base_s / expected.outside_s)),
              1e-12);
    EXPECT_LT(std::abs(t.p - expected.p.transmitted * std::sqrt(expected.base_p / expected.outside_p)),
              1e-12);
  });
}

// Beyond the critical angle of an air gap light still tunnels through 120 nm of it, and hardly through 3
// micrometres.
TEST(ThinFilm, LightTunnelsThroughANarrowGap) {
  const double cos_i = cos_deg(60);
  const double narrow = std::norm(film_transmission(Film{1.5, 1.0, 1.5, 120}, cos_i, 550.0).s);
  EXPECT_GT(narrow, 0.1);
  EXPECT_LT(narrow, 0.9);
  EXPECT_LT(std::norm(film_transmission(Film{1.5, 1.0, 1.5, 3000}, cos_i, 550.0).s), 1e-12);
  EXPECT_EQ(std::norm(film_transmission(Film{1.5, 1.2, 1.0, 100}, cos_i, 550.0).p), 0) << "no wave beyond";
}

TEST(ThinFilm, ItsMuellerMatrixPolarisesNothingMoreThanFully) {
  for_each_setting([](const Film& film, double degrees, double nm) {
    const auto mueller = film_mueller(film, cos_deg(degrees), nm);
    EXPECT_NEAR(mueller.mean, film_reflectance(film, cos_deg(degrees), nm), 1e-15);
    for (const Stokes<double>& light :
         {Stokes<double>{1, 0, 1, 0}, Stokes<double>{1, 0, 0, -1}, Stokes<double>{1, 0.6, 0, 0.8}})
      EXPECT_LE(degree_of_polarisation(mueller * light), 1 + 1e-12);
  });
}

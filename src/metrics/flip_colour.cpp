#include "metrics/flip_colour.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace orbs::metrics::flip {

namespace {

constexpr float kQc = 0.7F;
constexpr float kPc = 0.4F;
constexpr float kPt = 0.95F;

// Linear Rec.709 to XYZ over the white of D65, so that white is (1, 1, 1): the matrix of the paper's code
// with its rows divided by their sums.
constexpr double kX0 = 10135552.0, kX1 = 8788810.0, kX2 = 4435075.0;
constexpr double kY0 = 2613072.0, kY1 = 8788810.0, kY2 = 887015.0;
constexpr double kZ0 = 1425312.0, kZ1 = 8788810.0, kZ2 = 70074185.0;

// Row i of the adjugate over the determinant of the same matrix.
std::array<Colour, 3> inverse_matrix() {
  const double x = kX0 + kX1 + kX2;
  const double y = kY0 + kY1 + kY2;
  const double z = kZ0 + kZ1 + kZ2;
  const std::array<std::array<double, 3>, 3> m{
      {{kX0 / x, kX1 / x, kX2 / x}, {kY0 / y, kY1 / y, kY2 / y}, {kZ0 / z, kZ1 / z, kZ2 / z}}};
  std::array<std::array<double, 3>, 3> cofactors{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      cofactors.at(i).at(j) = m.at((i + 1) % 3).at((j + 1) % 3) * m.at((i + 2) % 3).at((j + 2) % 3) -
                              m.at((i + 1) % 3).at((j + 2) % 3) * m.at((i + 2) % 3).at((j + 1) % 3);
  const double determinant =
      m[0][0] * cofactors[0][0] + m[0][1] * cofactors[0][1] + m[0][2] * cofactors[0][2];
  std::array<Colour, 3> inverse{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      inverse.at(i).at(j) = static_cast<float>(cofactors.at(j).at(i) / determinant);
  return inverse;
}

float lab_curve(float t) {
  constexpr float kDelta = 6.0F / 29.0F;
  return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3.0F * kDelta * kDelta) + 4.0F / 29.0F;
}

float hyab(const Colour& a, const Colour& b) {
  const float da = a[1] - b[1];
  const float db = a[2] - b[2];
  return std::fabs(a[0] - b[0]) + std::sqrt(da * da + db * db);
}

}  // namespace

Colour to_xyz(const Colour& rgb) {
  const auto row = [&](double r, double g, double b) {
    const double sum = r + g + b;
    return static_cast<float>(r / sum) * rgb[0] + static_cast<float>(g / sum) * rgb[1] +
           static_cast<float>(b / sum) * rgb[2];
  };
  return {row(kX0, kX1, kX2), row(kY0, kY1, kY2), row(kZ0, kZ1, kZ2)};
}

Colour to_rgb_in_gamut(const Colour& xyz) {
  static const auto kInverse = inverse_matrix();
  const auto row = [&](const Colour& m) {
    return std::clamp(m[0] * xyz[0] + m[1] * xyz[1] + m[2] * xyz[2], 0.0F, 1.0F);
  };
  return {row(kInverse[0]), row(kInverse[1]), row(kInverse[2])};
}

Colour to_ycxcz(const Colour& xyz) {
  return {116.0F * xyz[1] - 16.0F, 500.0F * (xyz[0] - xyz[1]), 200.0F * (xyz[1] - xyz[2])};
}

Colour from_ycxcz(const Colour& ycxcz) {
  const float y = (ycxcz[0] + 16.0F) / 116.0F;
  return {y + ycxcz[1] / 500.0F, y, y - ycxcz[2] / 200.0F};
}

Colour to_hunt_lab(const Colour& xyz) {
  const float fx = lab_curve(xyz[0]);
  const float fy = lab_curve(xyz[1]);
  const float fz = lab_curve(xyz[2]);
  const float lightness = 116.0F * fy - 16.0F;
  return {lightness, 0.01F * lightness * 500.0F * (fx - fy), 0.01F * lightness * 200.0F * (fy - fz)};
}

float colour_error(const Colour& a, const Colour& b) {
  static const float kMost =
      std::pow(hyab(to_hunt_lab(to_xyz({0, 1, 0})), to_hunt_lab(to_xyz({0, 0, 1}))), kQc);
  const float bend = kPc * kMost;
  const float distance = std::pow(hyab(a, b), kQc);
  if (distance < bend) return distance * kPt / bend;
  return kPt + (distance - bend) / (kMost - bend) * (1.0F - kPt);
}

}  // namespace orbs::metrics::flip

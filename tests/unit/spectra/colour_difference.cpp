#include "unit/spectra/colour_difference.h"

#include <cmath>
#include <numbers>

namespace orbs::spectra {

namespace {

double lab_root(double ratio) {
  constexpr double kBend = 24.0 / 116;  // below its cube the curve is its tangent
  return ratio > kBend * kBend * kBend ? std::cbrt(ratio) : (841.0 / 108) * ratio + 16.0 / 116;
}

double cos_deg(double degrees) { return std::cos(degrees * (std::numbers::pi / 180)); }
double sin_deg(double degrees) { return std::sin(degrees * (std::numbers::pi / 180)); }

// In [0, 360); 0 for grey, whose hue does not count.
double hue_deg(double a, double b) {
  if (a == 0 && b == 0) return 0;
  const double hue = std::atan2(b, a) * (180 / std::numbers::pi);
  return hue < 0 ? hue + 360 : hue;
}

// sqrt(c^7 / (c^7 + 25^7)): 0 for grey, towards 1 for strong colours.
double saturation(double chroma) {
  const double c7 = std::pow(chroma, 7);
  return std::sqrt(c7 / (c7 + std::pow(25.0, 7)));
}

struct Cylinder {
  double l;
  double chroma;
  double hue_deg;
};

// Eq. 2 to 7: a is stretched near grey.
Cylinder stretched(Lab lab, double mean_chroma) {
  const double a = lab.a * (1 + 0.5 * (1 - saturation(mean_chroma)));
  return {lab.l, std::hypot(a, lab.b), hue_deg(a, lab.b)};
}

// Eq. 10: the shorter way around.
double hue_change_deg(const Cylinder& first, const Cylinder& second) {
  if (first.chroma * second.chroma == 0) return 0;
  const double change = second.hue_deg - first.hue_deg;
  if (change > 180) return change - 360;
  return change < -180 ? change + 360 : change;
}

// Eq. 14.
double mean_hue_deg(const Cylinder& first, const Cylinder& second) {
  const double sum = first.hue_deg + second.hue_deg;
  if (first.chroma * second.chroma == 0) return sum;
  if (std::abs(first.hue_deg - second.hue_deg) <= 180) return sum / 2;
  return sum < 360 ? (sum + 360) / 2 : (sum - 360) / 2;
}

}  // namespace

Lab lab_of(Vec3d xyz, Vec3d white_xyz) {
  const double x = lab_root(xyz.x / white_xyz.x);
  const double y = lab_root(xyz.y / white_xyz.y);
  const double z = lab_root(xyz.z / white_xyz.z);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

double ciede2000(Lab first, Lab second) {
  const double mean_chroma = (std::hypot(first.a, first.b) + std::hypot(second.a, second.b)) / 2;
  const Cylinder one = stretched(first, mean_chroma);
  const Cylinder two = stretched(second, mean_chroma);
  const double hue_difference =
      2 * std::sqrt(one.chroma * two.chroma) * sin_deg(hue_change_deg(one, two) / 2);
  const double l = (one.l + two.l) / 2;
  const double chroma = (one.chroma + two.chroma) / 2;
  const double hue = mean_hue_deg(one, two);
  const double t = 1 - 0.17 * cos_deg(hue - 30) + 0.24 * cos_deg(2 * hue) + 0.32 * cos_deg(3 * hue + 6) -
                   0.20 * cos_deg(4 * hue - 63);
  const double from_blue = (hue - 275) / 25;
  const double rotation = -sin_deg(2 * 30 * std::exp(-from_blue * from_blue)) * 2 * saturation(chroma);
  const double from_middle = (l - 50) * (l - 50);
  const double dl = (two.l - one.l) / (1 + 0.015 * from_middle / std::sqrt(20 + from_middle));
  const double dc = (two.chroma - one.chroma) / (1 + 0.045 * chroma);
  const double dh = hue_difference / (1 + 0.015 * chroma * t);
  return std::sqrt(dl * dl + dc * dc + dh * dh + rotation * dc * dh);
}

}  // namespace orbs::spectra

#include "analytic/reflectance.h"

#include "base/nth.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace orbs::analytic {

namespace {

constexpr double kPi = std::numbers::pi;

double smith_lambda(double alpha, double cosine) {
  const double tangent_squared = (1 - cosine) * (1 + cosine) / (cosine * cosine);
  return (std::sqrt(1 + alpha * alpha * tangent_squared) - 1) / 2;
}

}  // namespace

Quadrature gauss_legendre(int count) {
  Quadrature rule;
  for (int i = 1; i <= count; ++i) {
    double x = std::cos(kPi * (i - 0.25) / (count + 0.5));  // Newton's method from Tricomi's estimate
    double slope = 1;
    for (int step = 0; step < 100; ++step) {
      double p = 1;
      double before = 0;
      for (int j = 1; j <= count; ++j) {
        const double older = before;
        before = p;
        p = ((2 * j - 1) * x * before - (j - 1) * older) / j;
      }
      slope = count * (x * p - before) / (x * x - 1);
      const double by = p / slope;
      x -= by;
      if (std::fabs(by) < 1e-15) break;
    }
    rule.nodes.push_back((1 - x) / 2);
    rule.weights.push_back(1 / ((1 - x * x) * slope * slope));
  }
  return rule;
}

double oren_nayar_albedo(double roughness, double theta) {
  const double sigma = roughness * kPi / 2;
  const double a = 1 - 0.5 * sigma * sigma / (sigma * sigma + 0.33);
  const double b = 0.45 * sigma * sigma / (sigma * sigma + 0.09);
  const double sine = std::sin(theta);
  const double cosine = std::cos(theta);
  // tan (1 - sin^3) without the 0 times infinity of a right angle: 1 - sin^3 = (1 - sin)(1 + sin + sin^2).
  const double grazing = sine * cosine * (1 + sine + sine * sine) / (1 + sine);
  return a + 2 * b / kPi * (sine * (theta - sine * cosine) / 2 + grazing / 3);
}

double ggx_albedo(double alpha, double cosine) {
  constexpr int kCosines = 160;
  constexpr int kAzimuths = 256;
  static const auto rule = gauss_legendre(kCosines);
  const double mu = std::max(cosine, 1e-6);
  const double sine = std::sqrt((1 - mu) * (1 + mu));
  const double lambda = smith_lambda(alpha, mu);
  double sum = 0;
  for (int i = 0; i < kCosines; ++i) {
    const double in = nth(rule.nodes, i);
    const double in_sine = std::sqrt((1 - in) * (1 + in));
    const double g2 = 1 / (1 + lambda + smith_lambda(alpha, in));
    double over_azimuths = 0;
    for (int j = 0; j < kAzimuths; ++j) {
      const double phi = (j + 0.5) * kPi / kAzimuths;
      const double x = sine + in_sine * std::cos(phi);
      const double y = in_sine * std::sin(phi);
      const double z = mu + in;
      const double squared = x * x + y * y + z * z;
      const double s = ((x * x + y * y) / (alpha * alpha) + z * z) / squared;
      over_azimuths += 1 / (kPi * alpha * alpha * s * s);
    }
    sum += nth(rule.weights, i) * g2 * over_azimuths * 2 * kPi / kAzimuths / (4 * mu);
  }
  return sum;
}

double fresnel_reflectance(double cosine, double n, double k) {
  const double sine_squared = (1 - cosine) * (1 + cosine);
  const std::complex<double> m(n, k);
  const auto q = std::sqrt(m * m - sine_squared);  // the principal root: total reflection has q = i |q|
  const auto s = (cosine - q) / (cosine + q);
  const auto p = (m * m * cosine - q) / (m * m * cosine + q);
  return (std::norm(s) + std::norm(p)) / 2;
}

std::array<double, 3> fresnel_plane(const registry::FresnelPlane& image, const Ray& ray) {
  const double cosine = std::fabs(dot(image.normal, ray.direction));
  std::array<double, 3> out{};
  for (std::size_t c = 0; c < out.size(); ++c) {
    const double r = fresnel_reflectance(cosine, image.n.at(c), image.k.at(c));
    out.at(c) = image.radiance * (image.plates == 0 ? r : (1 - r) / (1 + (2 * image.plates - 1) * r));
  }
  return out;
}

}  // namespace orbs::analytic

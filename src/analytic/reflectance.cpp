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

// (1 - cos)^5 at the half vector, which has the angle between the directions halved on each side.
double schlick_weight(double between) { return std::pow(1 - std::sqrt((1 + between) / 2), 5); }

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

BrdfOfCosines ggx_brdf(double alpha, Masking masking) {
  return [=](double out, double in, double between) {
    // The half vector m is (wo + wi) over its length, whose square is 2 + 2 between.
    const double z_squared = (out + in) * (out + in) / (2 + 2 * between);
    const double s = (1 - z_squared) / (alpha * alpha) + z_squared;
    const double lambda_out = smith_lambda(alpha, out);
    const double lambda_in = smith_lambda(alpha, in);
    const double g2 = masking == Masking::Correlated ? 1 / (1 + lambda_out + lambda_in)
                                                     : 1 / ((1 + lambda_out) * (1 + lambda_in));
    return g2 / (kPi * alpha * alpha * s * s) / (4 * out);
  };
}

BrdfOfCosines metal_brdf(double reflectance, double alpha) {
  return [reflectance, ggx = ggx_brdf(alpha, Masking::Correlated)](double out, double in, double between) {
    const double weight = schlick_weight(between);
    return (reflectance + (1 - reflectance) * weight) * ggx(out, in, between);
  };
}

BrdfOfCosines metallic_roughness_brdf(double base, double metallic, double roughness) {
  return
      [=, ggx = ggx_brdf(roughness * roughness, Masking::Separable)](double out, double in, double between) {
        const double weight = schlick_weight(between);
        const double facets = ggx(out, in, between);
        const double fresnel = 0.04 + 0.96 * weight;
        const double dielectric = (1 - fresnel) * base / kPi * in + fresnel * facets;
        return (1 - metallic) * dielectric + metallic * (base + (1 - base) * weight) * facets;
      };
}

BrdfOfCosines phong_brdf(double reflectance, double exponent) {
  return [=](double out, double in, double between) {
    // Mirroring turns the azimuth by half a circle: the part of the cosine across the normal changes its
    // sign.
    const double cosine = std::max(0.0, 2 * out * in - between);
    return reflectance * (exponent + 2) / (2 * kPi) * std::pow(cosine, exponent) * in;
  };
}

double directional_albedo(const BrdfOfCosines& brdf, double cosine) {
  constexpr int kCosines = 160;
  constexpr int kAzimuths = 256;
  static const auto rule = gauss_legendre(kCosines);
  const double out = std::max(cosine, 1e-6);
  const double sine = std::sqrt((1 - out) * (1 + out));
  double sum = 0;
  for (int i = 0; i < kCosines; ++i) {
    const double in = nth(rule.nodes, i);
    const double in_sine = std::sqrt((1 - in) * (1 + in));
    double over_azimuths = 0;
    for (int j = 0; j < kAzimuths; ++j)
      over_azimuths += brdf(out, in, out * in + sine * in_sine * std::cos((j + 0.5) * kPi / kAzimuths));
    sum += nth(rule.weights, i) * over_azimuths * 2 * kPi / kAzimuths;
  }
  return sum;
}

FresnelAmplitudes fresnel_amplitudes(double cosine, double n, double k) {
  const double sine_squared = (1 - cosine) * (1 + cosine);
  const std::complex<double> m(n, k);
  const auto q = std::sqrt(m * m - sine_squared);  // the principal root: total reflection has q = i |q|
  return {(cosine - q) / (cosine + q), (m * m * cosine - q) / (m * m * cosine + q)};
}

double fresnel_reflectance(double cosine, double n, double k) {
  const auto amplitudes = fresnel_amplitudes(cosine, n, k);
  return (std::norm(amplitudes.s) + std::norm(amplitudes.p)) / 2;
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

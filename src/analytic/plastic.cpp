#include "analytic/plastic.h"

#include "base/nth.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace orbs::analytic {

namespace {

template <typename Part>
double of_diffuse_light(const Part& part) {
  constexpr int kCosines = 64;
  static const auto rule = gauss_legendre(kCosines);
  double sum = 0;
  for (int i = 0; i < kCosines; ++i)
    sum += nth(rule.weights, i) * 2 * nth(rule.nodes, i) * part(nth(rule.nodes, i));
  return sum;
}

}  // namespace

double fresnel_of_diffuse_light(double n) {
  if (n == 1) return 0;
  const double n2 = n * n;
  const double n4 = n2 * n2;
  return 0.5 + (n - 1) * (3 * n + 1) / (6 * (n + 1) * (n + 1)) +
         n2 * (n2 - 1) * (n2 - 1) / std::pow(n2 + 1, 3) * std::log((n - 1) / (n + 1)) -
         2 * n2 * n * (n2 + 2 * n - 1) / ((n2 + 1) * (n4 - 1)) +
         8 * n4 * (n4 + 1) / ((n2 + 1) * (n4 - 1) * (n4 - 1)) * std::log(n);
}

FacetParts parts_by_facets(double eta, double alpha, double cosine) {
  constexpr int kSlopes = 100;
  constexpr int kAzimuths = 100;
  const auto g1 = [alpha](double c) {
    return 2 / (1 + std::sqrt(1 + alpha * alpha * (1 - c) * (1 + c) / (c * c)));
  };
  const double sine = std::sqrt((1 - cosine) * (1 + cosine));
  FacetParts sum;
  for (int i = 0; i < kSlopes; ++i) {
    // Of the microfacets the part v^2 is steeper. Even steps of v and not of v^2 find the long tail of GGX.
    const double v = (i + 0.5) / kSlopes;
    const double slope = alpha * std::sqrt((1 - v) * (1 + v)) / v;
    const double cos_m = 1 / std::sqrt(1 + slope * slope);
    for (int j = 0; j < kAzimuths; ++j) {
      const double azimuth = (j + 0.5) * std::numbers::pi / kAzimuths;
      const double between = std::min(cos_m * (cosine + sine * slope * std::cos(azimuth)), 1.0);
      if (!(between > 0)) continue;
      const double f = fresnel_reflectance(between, eta, 0);
      const double mirrored = 2 * between * cos_m - cosine;
      if (mirrored > 0) sum.reflected += 2 * v * f * g1(mirrored) * between / cos_m;
      // The refracted direction is -wo / eta + m (between / eta - cos_t).
      const double cos_t = std::sqrt(std::max(0.0, 1 - (1 - between * between) / (eta * eta)));
      const double below = cosine / eta - cos_m * (between / eta - cos_t);
      if (below > 0) sum.transmitted += 2 * v * (1 - f) * g1(below) * between / cos_m;
    }
  }
  const double scale = g1(cosine) / cosine / (kSlopes * kAzimuths);
  return {sum.reflected * scale, sum.transmitted * scale};
}

PlasticAlbedo::PlasticAlbedo(const Plastic& plastic) : plastic_(plastic) {
  double entering = 1 - fresnel_of_diffuse_light(plastic.ior);
  inside_ = 1 - entering / (plastic.ior * plastic.ior);
  if (plastic.alpha > 0) {
    entering = of_diffuse_light([&](double cosine) { return parts(cosine).transmitted; });
    inside_ = of_diffuse_light(
        [&](double cosine) { return parts_by_facets(1 / plastic.ior, plastic.alpha, cosine).reflected; });
  }
  const double q = plastic.is_nonlinear ? plastic.reflectance * inside_ : inside_;
  base_ = plastic.reflectance / (1 - q) * entering / (plastic.ior * plastic.ior);
}

FacetParts PlasticAlbedo::parts(double cosine) const {
  if (plastic_.alpha == 0) {
    const double f = fresnel_reflectance(cosine, plastic_.ior, 0);
    return {f, 1 - f};
  }
  constexpr double kGrazing = 1e-6;  // at exactly grazing angles no microfacet is visible
  return parts_by_facets(plastic_.ior, plastic_.alpha, std::max(cosine, kGrazing));
}

double PlasticAlbedo::at(double cosine) const {
  const auto [reflected, transmitted] = parts(cosine);
  return reflected + transmitted * base_;
}

}  // namespace orbs::analytic

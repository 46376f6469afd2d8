#include "analytic/fresnel_plane.h"

#include <cmath>
#include <complex>

namespace orbs::analytic {

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

#pragma once

#include "analytic/ray.h"
#include "registry/analytic.h"

#include <array>
#include <complex>
#include <functional>
#include <vector>

/// Directional albedo: what a surface shows in a constant environment of radiance 1.

namespace orbs::analytic {

/// Of the Oren-Nayar model without interreflection and of reflectance 1, at the angle theta (radians) to the
/// normal; the integral of the BRDF of the scene format, times the cosine, in closed form:
/// A + 2 B / pi (sin(theta) (theta - sin(theta) cos(theta)) / 2 + tan(theta) (1 - sin(theta)^3) / 3).
double oren_nayar_albedo(double roughness, double theta);

/// A BRDF times the cosine of the incident direction, by the cosines of the angles of both directions to the
/// normal and of that between them.
using BrdfOfCosines = std::function<double(double out, double in, double between)>;

enum class Masking { Correlated, Separable };

/// The scene format's ggx without a Fresnel factor: D of Walter et al. 2007, G2 of Heitz 2014.
BrdfOfCosines ggx_brdf(double alpha, Masking masking = Masking::Correlated);
/// The same times Schlick's Fresnel factor.
BrdfOfCosines metal_brdf(double reflectance, double alpha);
/// glTF 2.0, appendix B.3.5 of its specification: separable masking; alpha is the square of the roughness.
BrdfOfCosines metallic_roughness_brdf(double base, double metallic, double roughness);
/// Lafortune and Willems 1994.
BrdfOfCosines phong_brdf(double reflectance, double exponent);

/// By the product of Gauss and Legendre's rule over the cosine of the incident direction and the midpoint
/// rule over the azimuth. For lobes of alpha >= 0.1 and of exponents to 100.
double directional_albedo(const BrdfOfCosines& brdf, double cosine);

/// Nodes and weights of Gauss and Legendre's rule on [0, 1].
struct Quadrature {
  std::vector<double> nodes;
  std::vector<double> weights;
};
Quadrature gauss_legendre(int count);

/// Reflected over incident field, s across the plane of incidence and p in it, for fields that vary as
/// exp(-i w t) and the relative index n + i k. p counts along the direction of the light cross s for both, so
/// that p = -s along the normal (Born and Wolf, 1.5.2 and figure 1.10).
struct FresnelAmplitudes {
  std::complex<double> s;
  std::complex<double> p;
};
FresnelAmplitudes fresnel_amplitudes(double cosine, double n, double k);

/// Reflectance of unpolarised light at the cosine of the angle to the normal, by the relative index n + i k
/// (Born and Wolf, 1.5.2 and 14.2); 1 where everything is reflected.
double fresnel_reflectance(double cosine, double n, double k);

/// What the image shows along the ray: the radiance times R, or times (1 - R) / (1 + (2 plates - 1) R), the
/// sum over all reflections between the 2 plates surfaces of an incoherent stack (Stokes 1862). Both hold
/// for a renderer without polarisation.
std::array<double, 3> fresnel_plane(const registry::FresnelPlane& image, const Ray& ray);

}  // namespace orbs::analytic

#pragma once

#include "analytic/reflectance.h"

namespace orbs::analytic {

/// The scene format's plastic.
struct Plastic {
  double reflectance = 1;  // of the base
  double ior = 1.5;
  bool is_nonlinear = false;
  double alpha = 0;  // of GGX with separable masking; 0 is smooth
};

/// What a smooth boundary reflects of diffuse light from the side of the smaller index: 2 times the integral
/// of Fresnel's reflectance times the cosine, in closed form (Walsh 1926, in Duntley 1942, eq. 41).
double fresnel_of_diffuse_light(double n);

/// What a rough boundary, with the index beyond it over that before it, makes of light from one direction:
/// the integrals of F D G1 G1 / (4 cos cos) and of the transmission of Walter et al. 2007, eq. 21, times the
/// cosine, by the midpoint rule over the microfacets. With half as many points they differ by 1e-4 at a
/// cosine of 0.1 and by less at larger ones.
struct FacetParts {
  double reflected = 0;
  double transmitted = 0;
};
FacetParts parts_by_facets(double eta, double alpha, double cosine);

/// The directional albedo: what the boundary reflects, and what it lets through times what the base sends out
/// again, R + T rho / (1 - q) To / ior^2, where To is what the boundary lets through of diffuse light, and Ri
/// what it reflects of that from inside; q is Ri, times rho if it is nonlinear. Of a smooth boundary To /
/// ior^2 is 1 - Ri.
class PlasticAlbedo {
 public:
  explicit PlasticAlbedo(const Plastic& plastic);
  double at(double cosine) const;
  /// Ri.
  double reflected_inside() const { return inside_; }

 private:
  FacetParts parts(double cosine) const;

  Plastic plastic_;
  double inside_ = 0;
  double base_ = 0;  // of what enters, what leaves again
};

}  // namespace orbs::analytic

#pragma once

// Isotropic microfacets with the GGX and the Beckmann distribution: distribution of normals,
// masking-shadowing, and sampling of the visible normals. Free to copy into any renderer: C++20, the standard
// library only.
//
// Directions are unit vectors in the local frame of the surface (z along its normal) and point away from it.
// V is any struct with x, y and z that can be written V{x, y, z}; V2 has x and y. `alpha` is the roughness of
// the papers, not its square root.
//
//   reflection        f = F D(m) G2(wo, wi) / (4 wo.z wi.z)               with m the half vector
//   its sampling      m = sample_ggx_visible(wo, alpha, d), wi = m reflected
//   its pdf           ggx_visible_d(wo, m, alpha) / (4 |wo.m|)            per solid angle of wi
//   its weight        f |wi.z| / pdf     = F G2(wo, wi) / G1(wo)
//
// Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces"; Heitz 2014, "Understanding
// the Masking-Shadowing Function in Microfacet-Based BRDFs"; Heitz 2018, "Sampling the GGX Distribution of
// Visible Normals".

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace snippets {

template <typename V>
using RealOf = decltype(V{}.x);

template <typename V>
constexpr RealOf<V> dot3(V a, V b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <typename V>
V normalised3(V a) {
  const RealOf<V> scale = RealOf<V>(1) / std::sqrt(dot3(a, a));
  return V{a.x * scale, a.y * scale, a.z * scale};
}

/// Masking function G1 of w, from Smith's Lambda of w.
template <typename Real>
constexpr Real smith_g1(Real lambda) {
  return 1 / (1 + lambda);
}

/// Height-correlated masking-shadowing function G2 of two directions on one side (Heitz 2014, eq. 99).
template <typename Real>
constexpr Real smith_g2_correlated(Real lambda_o, Real lambda_i) {
  return 1 / (1 + lambda_o + lambda_i);
}

/// Separable masking-shadowing function (Walter eq. 23): darker, and the usual choice for directions on
/// opposite sides.
template <typename Real>
constexpr Real smith_g2_separable(Real lambda_o, Real lambda_i) {
  return smith_g1(lambda_o) * smith_g1(lambda_i);
}

/// GGX distribution of microfacet normals, per solid angle; 0 below the horizon. This is Walter eq. 33
/// written with the components of m, because 1 - cos^2 cancels near the highlight (19 % error in float at
/// alpha = 1e-3).
template <typename V>
RealOf<V> ggx_d(V m, RealOf<V> alpha) {
  using Real = RealOf<V>;
  if (m.z <= 0) return 0;
  const Real x = m.x / alpha;
  const Real y = m.y / alpha;
  const Real s = x * x + y * y + m.z * m.z;
  return 1 / (std::numbers::pi_v<Real> * alpha * alpha * s * s);
}

/// Smith's Lambda of GGX (Heitz 2014, eq. 72); infinite at the horizon.
template <typename V>
RealOf<V> ggx_lambda(V w, RealOf<V> alpha) {
  using Real = RealOf<V>;
  const Real cos2 = w.z * w.z;
  if (cos2 == 0) return std::numeric_limits<Real>::infinity();
  const Real tan2 = (w.x * w.x + w.y * w.y) / cos2;
  return Real(0.5) * (std::sqrt(1 + alpha * alpha * tan2) - 1);
}

/// The same three for microfacets whose slopes differ: alpha_x along the x axis and alpha_y along y (Heitz
/// 2014, eq. 85 and 86). Stretched by 1 / alpha along each axis they are those of alpha = 1.
template <typename V>
RealOf<V> ggx_d(V m, RealOf<V> alpha_x, RealOf<V> alpha_y) {
  using Real = RealOf<V>;
  if (m.z <= 0) return 0;
  const Real x = m.x / alpha_x;
  const Real y = m.y / alpha_y;
  const Real s = x * x + y * y + m.z * m.z;
  return 1 / (std::numbers::pi_v<Real> * alpha_x * alpha_y * s * s);
}

template <typename V>
RealOf<V> ggx_lambda(V w, RealOf<V> alpha_x, RealOf<V> alpha_y) {
  return ggx_lambda(V{alpha_x * w.x, alpha_y * w.y, w.z}, RealOf<V>(1));
}

template <typename V>
RealOf<V> ggx_g1(V w, RealOf<V> alpha) {
  return smith_g1(ggx_lambda(w, alpha));
}

/// Distribution of the normals visible from wo (wo.z > 0), per solid angle of m: the pdf of
/// sample_ggx_visible.
template <typename V>
RealOf<V> ggx_visible_d(V wo, V m, RealOf<V> alpha) {
  return ggx_g1(wo, alpha) * std::abs(dot3(wo, m)) * ggx_d(m, alpha) / wo.z;
}

/// Samples a normal visible from wo (wo.z > 0), given a point uniformly distributed on the unit disk
/// (Heitz 2018, listing 1).
template <typename V, typename V2>
V sample_ggx_visible(V wo, RealOf<V> alpha_x, RealOf<V> alpha_y, V2 disk) {
  using Real = RealOf<V>;
  const V view = normalised3(V{alpha_x * wo.x, alpha_y * wo.y, wo.z});
  const Real across2 = view.x * view.x + view.y * view.y;
  const Real scale = across2 > 0 ? Real(1) / std::sqrt(across2) : 0;
  const V t1 = across2 > 0 ? V{-view.y * scale, view.x * scale, 0 * scale} : V{1, 0, 0};
  const V t2{view.y * t1.z - view.z * t1.y, view.z * t1.x - view.x * t1.z, view.x * t1.y - view.y * t1.x};
  const Real s = Real(0.5) * (1 + view.z);
  // The maximum is for rounding only: neither argument is negative on the projected hemisphere.
  const Real y = (1 - s) * std::sqrt(std::max(Real(0), 1 - disk.x * disk.x)) + s * disk.y;
  const Real z = std::sqrt(std::max(Real(0), 1 - disk.x * disk.x - y * y));
  const V n{t1.x * disk.x + t2.x * y + view.x * z, t1.y * disk.x + t2.y * y + view.y * z,
            t1.z * disk.x + t2.z * y + view.z * z};
  // 1e-9 keeps the normal above the horizon.
  return normalised3(V{alpha_x * n.x, alpha_y * n.y, std::max(Real(1e-9), n.z)});
}

template <typename V, typename V2>
V sample_ggx_visible(V wo, RealOf<V> alpha, V2 disk) {
  return sample_ggx_visible(wo, alpha, alpha, disk);
}

/// exp and erfc, of a float too by the functions for double: those for floats are not the same in all
/// libraries, and so would images not be.
template <typename Real>
Real exp_of(Real x) {
  return static_cast<Real>(std::exp(static_cast<double>(x)));
}

template <typename Real>
Real erfc_of(Real x) {
  return static_cast<Real>(std::erfc(static_cast<double>(x)));
}

/// Beckmann distribution of microfacet normals, per solid angle (Walter eq. 25).
template <typename V>
RealOf<V> beckmann_d(V m, RealOf<V> alpha) {
  using Real = RealOf<V>;
  if (m.z <= 0) return 0;
  const Real cos2 = m.z * m.z;
  const Real alpha2 = alpha * alpha;
  return exp_of(-(m.x * m.x + m.y * m.y) / (alpha2 * cos2)) /
         (std::numbers::pi_v<Real> * alpha2 * cos2 * cos2);
}

/// Smith's Lambda of Beckmann, exact (Heitz 2014, eq. 68; the usual rational fit has errors of up to 0.4 %).
template <typename V>
RealOf<V> beckmann_lambda(V w, RealOf<V> alpha) {
  using Real = RealOf<V>;
  const Real sine = std::sqrt(w.x * w.x + w.y * w.y);
  if (w.z == 0) return std::numeric_limits<Real>::infinity();
  if (sine == 0) return 0;
  const Real a = std::abs(w.z) / (alpha * sine);
  return (exp_of(-a * a) * std::numbers::inv_sqrtpi_v<Real> / a - erfc_of(a)) / 2;
}

template <typename V>
RealOf<V> beckmann_g1(V w, RealOf<V> alpha) {
  return smith_g1(beckmann_lambda(w, alpha));
}

/// Distribution of the normals visible from wo, as ggx_visible_d.
template <typename V>
RealOf<V> beckmann_visible_d(V wo, V m, RealOf<V> alpha) {
  return beckmann_g1(wo, alpha) * std::abs(dot3(wo, m)) * beckmann_d(m, alpha) / wo.z;
}

/// Samples the slope x along the view direction of microfacets with alpha = 1, seen at an angle whose tangent
/// is `tangent` (non-negative): inverts the cumulative distribution of (1 - tangent x) exp(-x^2) over x < 1 /
/// tangent at u. There is no inverse in closed form, so Newton's method is used, with bisection where a step
/// leaves the bracket.
template <typename Real>
Real beckmann_visible_slope(Real tangent, Real u) {
  constexpr Real kInvSqrtPi = std::numbers::inv_sqrtpi_v<Real>;
  // Cumulative distribution at x, up to the constant that normalises it.
  const auto below = [&](Real x) { return erfc_of(-x) / 2 + tangent * exp_of(-x * x) * kInvSqrtPi / 2; };
  const Real end = tangent > 0 ? 1 / tangent : std::numeric_limits<Real>::infinity();
  const Real far =
      std::numeric_limits<Real>::digits > 24 ? Real(6) : Real(4.2);  // erfc there is below one ulp of 1
  Real low = -far;
  Real high = std::min(end, far);
  const Real goal = u * below(high);
  Real x = std::min(Real(0), high);
  const Real resolution = 4 * std::numeric_limits<Real>::epsilon();
  while (high - low > resolution) {
    const Real error = below(x) - goal;
    (error > 0 ? high : low) = x;
    const Real step = error / ((1 - tangent * x) * exp_of(-x * x) * kInvSqrtPi);
    if (std::abs(step) <= resolution) break;
    const Real next = x - step;
    x = next > low && next < high ? next : low + (high - low) / 2;
    if (x <= low || x >= high) break;  // there is no number in between
  }
  return x;
}

/// Samples a normal visible from wo (wo.z > 0), given two numbers in [0, 1). The slopes across the view
/// direction do not depend on it (Heitz and d'Eon 2014, "Importance Sampling Microfacet-Based BSDFs using the
/// Distribution of Visible Normals").
template <typename V>
V sample_beckmann_visible(V wo, RealOf<V> alpha, RealOf<V> u, RealOf<V> v) {
  using Real = RealOf<V>;
  const Real sine = std::sqrt(wo.x * wo.x + wo.y * wo.y);
  const Real along = alpha * beckmann_visible_slope(alpha * sine / wo.z, u);
  const Real across = alpha * beckmann_visible_slope(Real(0), v);
  const Real cos_phi = sine > 0 ? wo.x / sine : 1;
  const Real sin_phi = sine > 0 ? wo.y / sine : 0;
  return normalised3(V{-(cos_phi * along - sin_phi * across), -(sin_phi * along + cos_phi * across), 1});
}

}  // namespace snippets

#include "tracer/bsdf/plastic_coat.h"

#include "base/in_double.h"
#include "tracer/bsdf/fresnel.h"
#include "tracer/bsdf/microfacets.h"

#include <algorithm>
#include <cmath>

namespace orbs::tracer {

namespace {

struct Parts {
  float reflected = 0;
  float transmitted = 0;
};

// What a rough boundary makes of light from one direction: the integrals of F G1 G1 (wo.m) / (cos_m cos_o),
// and of 1 - F for F with the masking of the refracted direction, over D(m) cos_m by the midpoint rule. Of
// that, the part v^2 is steeper than tan = alpha sqrt(1 - v^2) / v: even steps of v find the long tail of
// GGX, where those of v^2, or of samples of the visible normals, are off by 5e-3. Of the azimuth one half
// mirrors the other.
Parts parts_by_facets(float eta, float alpha, float cosine) {
  constexpr int kSlopes = 128;
  constexpr int kAzimuths = 64;
  const Microfacets facets{.alpha = alpha};
  const Vec3f wo{std::sqrt((1 - cosine) * (1 + cosine)), 0, cosine};
  double reflected = 0;
  double transmitted = 0;
  for (int i = 0; i < kSlopes; ++i) {
    const float v = (static_cast<float>(i) + 0.5F) / kSlopes;
    const float slope = alpha * std::sqrt((1 - v) * (1 + v)) / v;
    const float cos_m = 1 / std::sqrt(1 + slope * slope);
    for (int j = 0; j < kAzimuths; ++j) {
      const float azimuth = (static_cast<float>(j) + 0.5F) * kPi / kAzimuths;
      const Vec3f m = Vec3f{slope * in_double::cos(azimuth), slope * in_double::sin(azimuth), 1} * cos_m;
      const float cos_o = std::min(dot(wo, m), 1.0F);  // rounding only: both are unit vectors
      if (!(cos_o > 0)) continue;
      const float fresnel = fresnel_dielectric(cos_o, eta);
      const float seen = 2 * v * cos_o / (cos_m * cosine);
      const Vec3f wi = m * (2 * cos_o) - wo;
      if (wi.z > 0) reflected += static_cast<double>(fresnel * facet_g2(facets, wo, wi) * seen);
      const auto wt = refracted(wo, m, eta);
      if (wt && wt->z < 0)
        transmitted += static_cast<double>((1 - fresnel) * facet_g2(facets, wo, *wt) * seen);
    }
  }
  constexpr double kShare = 1.0 / (kSlopes * kAzimuths);
  return {static_cast<float>(reflected * kShare), static_cast<float>(transmitted * kShare)};
}

// 2 times the integral of R(cos) cos by the midpoint rule.
template <typename Reflected>
float diffusely_reflected(int steps, const Reflected& reflected) {
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double cosine = (i + 0.5) / steps;
    sum += 2 * static_cast<double>(reflected(static_cast<float>(cosine))) * cosine;
  }
  return static_cast<float>(sum / steps);
}

}  // namespace

PlasticCoat make_coat(float eta, float alpha) {
  PlasticCoat coat;
  coat.eta = eta;
  coat.alpha = alpha;
  if (alpha == 0) {
    // Fresnel's formula is smooth in the cosine from outside, so 4096 steps leave nothing that floats hold.
    // From inside, where it has the edge of total reflection, what stays inside follows from what enters:
    // both directions let the same through, per squared index.
    const float reflected = diffusely_reflected(4096, [&](float c) { return fresnel_dielectric(c, eta); });
    coat.reflected_inside = 1 - (1 - reflected) / (eta * eta);
    return coat;
  }
  coat.reflected_inside =
      diffusely_reflected(kCoatSteps, [&](float c) { return parts_by_facets(1 / eta, alpha, c).reflected; });
  for (int i = 0; i <= kCoatSteps; ++i) {
    // No microfacet is visible at exactly grazing angles; a step is at most half off there.
    const float cosine = std::max(static_cast<float>(i), 0.5F) / kCoatSteps;
    coat.entering.push_back(parts_by_facets(eta, alpha, cosine).transmitted);
  }
  return coat;
}

}  // namespace orbs::tracer

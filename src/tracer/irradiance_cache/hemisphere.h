#pragma once

#include "base/vec.h"

#include <array>
#include <cstddef>
#include <limits>
#include <span>

/// Irradiance and its gradients from stratified samples of the hemisphere. All vectors are in the local frame
/// of the surface, z along its normal.
namespace orbs::tracer {

/// Strata of equal cosine-weighted solid angle: `rings` intervals of sin^2 of the polar angle times `sectors`
/// intervals of the azimuth.
struct HemisphereStrata {
  int rings = 1;
  int sectors = 3;

  std::size_t count() const { return static_cast<std::size_t>(rings) * static_cast<std::size_t>(sectors); }
};

/// About `rays` strata whose sides at the middle of the hemisphere are alike: sectors = pi rings (Ward and
/// Heckbert 1992). `rays` is 8 at least.
HemisphereStrata hemisphere_strata(int rays);

/// The unit direction at `place` in [0, 1)^2 of the stratum `index` = ring * sectors + sector.
Vec3f direction_in_stratum(const HemisphereStrata& strata, std::size_t index, Vec2f place);

/// What the ray of one stratum found.
struct IncomingLight {
  Vec3f radiance;
  float distance = std::numeric_limits<float>::infinity();  // in metres; infinite where it met nothing
};

struct HemisphereEstimate {
  Vec3f irradiance;  // W / m^2 for radiance in W / (m^2 sr)
  /// Of each channel, per metre: in the tangent plane.
  std::array<Vec3f, 3> translation_gradient;
  /// Of each channel, per radian. A normal n' close to the normal n changes the irradiance by (n x n') times
  /// this.
  std::array<Vec3f, 3> rotation_gradient;
  float harmonic_mean_distance = 0;  // of all rays; those that met nothing count as infinitely long
  float least_distance = 0;
};

/// `light` has one entry for each stratum, in the order of their indices.
HemisphereEstimate estimate_irradiance(const HemisphereStrata& strata, std::span<const IncomingLight> light);

}  // namespace orbs::tracer

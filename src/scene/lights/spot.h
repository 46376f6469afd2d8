#pragma once

#include "json/writer.h"
#include "scene/lights/placement.h"
#include "scene/lights/without_area.h"
#include "scene/load/entry.h"

#include <cmath>
#include <numbers>

namespace orbs::scene {

/// A point at the light's origin that shines about local -Y: with its whole intensity within the inner half
/// angle, and less and less of it up to the outer one.
struct SpotShape {
  static constexpr const char* kType = "spot";
  static constexpr const char* kRequirement = "D2";
  static constexpr const char* kWhat = "a spot";
  static constexpr const char* kEmission = "intensity";
  static constexpr bool kHasArea = false;
  static constexpr int kPowerOfScale = 2;
  double inner_deg = 30;  // half angles; inner_deg <= outer_deg
  double outer_deg = 45;
  bool operator==(const SpotShape&) const = default;
};

inline void load(json::ObjectReader& in, SpotShape& loaded) {
  constexpr json::Range kHalfAngle{0.01, 180};
  loaded.outer_deg = in.number("outer", kHalfAngle);
  loaded.inner_deg = in.number("inner", {0, 180});
  if (loaded.inner_deg > loaded.outer_deg)
    in.fail("inner", "must not be above 'outer': both are half angles");
}

inline void write(json::Writer& out, const SpotShape& spot) {
  out.member("inner", spot.inner_deg).member("outer", spot.outer_deg);
}

inline std::optional<SpotShape> absorbed(const SpotShape& spot, const Mat4& matrix) {
  return stays_level(matrix) ? std::optional(spot) : std::nullopt;
}

inline double cos_of_degrees(double degrees) { return std::cos(degrees * std::numbers::pi / 180); }

/// The share of its intensity that a spot sends at an angle of this cosine to its axis: a smoothstep of the
/// cosine between the two angles.
inline double share_of_intensity(double cos_inner, double cos_outer, double cosine) {
  if (!(cosine > cos_outer)) return 0;
  if (cosine >= cos_inner) return 1;
  const double t = (cosine - cos_outer) / (cos_inner - cos_outer);
  return t * t * (3 - 2 * t);
}

}  // namespace orbs::scene

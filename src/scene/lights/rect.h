#pragma once

#include "json/writer.h"
#include "scene/lights/light_type.h"
#include "scene/lights/placement.h"
#include "scene/load/entry.h"

#include <cmath>

namespace orbs::scene {

struct RectShape {
  static constexpr const char* kType = "rect";
  static constexpr const char* kRequirement = "L1";
  static constexpr const char* kProfileRequirement = "L4";
  static constexpr const char* kWhat = "an area light";
  static constexpr const char* kEmission = "radiance";
  static constexpr bool kHasArea = true;
  static constexpr int kPowerOfScale = 0;
  double half_width_m = 1;   // along local X
  double half_length_m = 1;  // along local Z
  bool operator==(const RectShape&) const = default;
};

inline void check_placed(json::ObjectReader&, const RectShape&, const Mat4&) {}
inline std::string beyond_levels(const RectShape&, const Mat4&) { return ""; }

inline void load(json::ObjectReader& in, RectShape& loaded) {
  loaded.half_width_m = in.number("half_width", kLength);
  loaded.half_length_m = in.number("half_length", kLength);
}

inline void write(json::Writer& out, const RectShape& rect) {
  out.member("half_width", rect.half_width_m).member("half_length", rect.half_length_m);
}

inline Vec3d half_size(const RectShape& rect) { return {rect.half_width_m, 0, rect.half_length_m}; }

inline double cross_section_m2(const RectShape& rect) { return 4 * rect.half_width_m * rect.half_length_m; }

// A rectangle stays one along the axes when X goes to X and Z to Z, or each to the other.
inline std::optional<RectShape> absorbed(const RectShape& rect, const Mat4& m) {
  if (!stays_level(m)) return std::nullopt;
  const double zero = kMatrixRounding * largest_entry(m);
  if (std::fabs(m(0, 2)) <= zero && std::fabs(m(2, 0)) <= zero)
    return RectShape{rect.half_width_m * std::fabs(m(0, 0)), rect.half_length_m * std::fabs(m(2, 2))};
  if (std::fabs(m(0, 0)) <= zero && std::fabs(m(2, 2)) <= zero)
    return RectShape{rect.half_length_m * std::fabs(m(0, 2)), rect.half_width_m * std::fabs(m(2, 0))};
  return std::nullopt;
}

inline LightHit hit(const RectShape& rect, Vec3d origin, Vec3d direction) {
  return flat_hit(origin, direction, [&](double x, double z) {
    return std::abs(x) <= rect.half_width_m && std::abs(z) <= rect.half_length_m;
  });
}

}  // namespace orbs::scene

#pragma once

#include "json/writer.h"
#include "scene/lights/light_type.h"
#include "scene/lights/placement.h"
#include "scene/load/entry.h"

#include <cmath>
#include <numbers>

namespace orbs::scene {

/// It shines outwards; its inside is black.
struct SphereShape {
  static constexpr const char* kType = "sphere";
  static constexpr const char* kRequirement = "L2";
  static constexpr const char* kProfileRequirement = "L4";
  static constexpr const char* kWhat = "a sphere";
  static constexpr const char* kEmission = "radiance";
  static constexpr bool kHasArea = true;
  static constexpr int kPowerOfScale = 0;
  double radius_m = 1;
  bool operator==(const SphereShape&) const = default;
};

inline void load(json::ObjectReader& in, SphereShape& loaded) {
  loaded.radius_m = in.number("radius", kLength);
}

inline void write(json::Writer& out, const SphereShape& sphere) { out.member("radius", sphere.radius_m); }

inline void check_placed(json::ObjectReader& in, const SphereShape& sphere, const Mat4& matrix) {
  const double r = sphere.radius_m;
  if (!inverse(matrix * scaling({r, r, r}))) in.fail("radius", "times the matrix is too small a sphere");
}

inline Vec3d half_size(const SphereShape& sphere) {
  return {sphere.radius_m, sphere.radius_m, sphere.radius_m};
}

inline double cross_section_m2(const SphereShape& sphere) {
  return std::numbers::pi * sphere.radius_m * sphere.radius_m;
}

inline std::optional<SphereShape> absorbed(const SphereShape& sphere, const Mat4& matrix) {
  const auto scale = uniform_scale(matrix);
  return scale ? std::optional(SphereShape{sphere.radius_m * *scale}) : std::nullopt;
}

inline std::string beyond_levels(const SphereShape&, const Mat4& matrix) {
  return uniform_scale(matrix) ? ""
                               : "is a sphere with a scale that is not uniform, which no level of ORB.S has";
}

inline LightHit hit(const SphereShape& sphere, Vec3d o, Vec3d d) {
  const double a = dot(d, d);
  const double half_b = dot(o, d);
  const double c = dot(o, o) - sphere.radius_m * sphere.radius_m;
  const double discriminant = half_b * half_b - a * c;
  if (discriminant < 0) return {};
  const double root = std::sqrt(discriminant);
  const double near = (-half_b - root) / a;
  const double far = (-half_b + root) / a;
  return near > 0 ? LightHit{near, true} : far > 0 ? LightHit{far, false} : LightHit{};
}

}  // namespace orbs::scene

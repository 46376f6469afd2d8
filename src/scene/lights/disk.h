#pragma once

#include "json/writer.h"
#include "scene/lights/light_type.h"
#include "scene/lights/placement.h"
#include "scene/load/entry.h"

#include <numbers>

namespace orbs::scene {

struct DiskShape {
  static constexpr const char* kType = "disk";
  static constexpr const char* kRequirement = "L1";
  static constexpr const char* kProfileRequirement = "L4";
  static constexpr const char* kWhat = "an area light";
  static constexpr const char* kEmission = "radiance";
  static constexpr bool kHasArea = true;
  static constexpr int kPowerOfScale = 0;
  double radius_m = 1;
  bool operator==(const DiskShape&) const = default;
};

inline void check_placed(json::ObjectReader&, const DiskShape&, const Mat4&) {}
inline std::string beyond_levels(const DiskShape&, const Mat4&) { return ""; }

inline void load(json::ObjectReader& in, DiskShape& loaded) {
  loaded.radius_m = in.number("radius", kLength);
}

inline void write(json::Writer& out, const DiskShape& disk) { out.member("radius", disk.radius_m); }

inline Vec3d half_size(const DiskShape& disk) { return {disk.radius_m, 0, disk.radius_m}; }

inline double cross_section_m2(const DiskShape& disk) {
  return std::numbers::pi * disk.radius_m * disk.radius_m;
}

inline std::optional<DiskShape> absorbed(const DiskShape& disk, const Mat4& matrix) {
  const auto scale = level_scale(matrix);
  return scale ? std::optional(DiskShape{disk.radius_m * *scale}) : std::nullopt;
}

inline LightHit hit(const DiskShape& disk, Vec3d origin, Vec3d direction) {
  return flat_hit(origin, direction,
                  [&](double x, double z) { return x * x + z * z <= disk.radius_m * disk.radius_m; });
}

}  // namespace orbs::scene

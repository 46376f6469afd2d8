#pragma once

#include "scene/lights/light_type.h"

namespace orbs::scene {

struct DiskShape {
  static constexpr const char* kType = "disk";
  static constexpr const char* kRequirement = "L1";
  static constexpr const char* kWhat = "an area light";
  double radius_m = 1;
  bool operator==(const DiskShape&) const = default;
};

void load(json::ObjectReader& in, DiskShape& loaded);
void write(json::Writer& out, const DiskShape& disk);
inline void check_placed(json::ObjectReader&, const DiskShape&, const Mat4&) {}
Vec3d half_size(const DiskShape& disk);
double cross_section_m2(const DiskShape& disk);
std::optional<DiskShape> absorbed(const DiskShape& disk, const Mat4& matrix);
inline std::string beyond_levels(const DiskShape&, const Mat4&) { return ""; }
LightHit hit(const DiskShape& disk, Vec3d origin, Vec3d direction);

}  // namespace orbs::scene

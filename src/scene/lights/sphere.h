#pragma once

#include "scene/lights/light_type.h"

namespace orbs::scene {

/// It shines outwards; its inside is black.
struct SphereShape {
  static constexpr const char* kType = "sphere";
  static constexpr const char* kRequirement = "L2";
  static constexpr const char* kWhat = "a sphere";
  double radius_m = 1;
  bool operator==(const SphereShape&) const = default;
};

void load(json::ObjectReader& in, SphereShape& loaded);
void write(json::Writer& out, const SphereShape& sphere);
void check_placed(json::ObjectReader& in, const SphereShape& sphere, const Mat4& matrix);
Vec3d half_size(const SphereShape& sphere);
double cross_section_m2(const SphereShape& sphere);
std::optional<SphereShape> absorbed(const SphereShape& sphere, const Mat4& matrix);
std::string beyond_levels(const SphereShape& sphere, const Mat4& matrix);
LightHit hit(const SphereShape& sphere, Vec3d origin, Vec3d direction);

}  // namespace orbs::scene

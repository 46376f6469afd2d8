#pragma once

#include "scene/lights/light_type.h"

namespace orbs::scene {

struct RectShape {
  static constexpr const char* kType = "rect";
  static constexpr const char* kRequirement = "L1";
  static constexpr const char* kWhat = "an area light";
  double half_width_m = 1;   // along local X
  double half_length_m = 1;  // along local Z
  bool operator==(const RectShape&) const = default;
};

void load(json::ObjectReader& in, RectShape& loaded);
void write(json::Writer& out, const RectShape& rect);
inline void check_placed(json::ObjectReader&, const RectShape&, const Mat4&) {}
Vec3d half_size(const RectShape& rect);
double cross_section_m2(const RectShape& rect);
std::optional<RectShape> absorbed(const RectShape& rect, const Mat4& matrix);
inline std::string beyond_levels(const RectShape&, const Mat4&) { return ""; }
LightHit hit(const RectShape& rect, Vec3d origin, Vec3d direction);

}  // namespace orbs::scene

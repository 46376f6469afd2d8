#pragma once

#include "json/writer.h"
#include "scene/lights/without_area.h"

namespace orbs::scene {

/// A point at the light's origin that shines to all sides with the same intensity, or by an IES profile.
struct PointShape {
  static constexpr const char* kType = "point";
  static constexpr const char* kRequirement = "D1";
  static constexpr const char* kProfileRequirement = "D4";
  static constexpr const char* kWhat = "a point";
  static constexpr const char* kEmission = "intensity";
  static constexpr bool kHasArea = false;
  static constexpr int kPowerOfScale = 2;
  bool operator==(const PointShape&) const = default;
};

inline void load(json::ObjectReader&, PointShape&) {}
inline void write(json::Writer&, const PointShape&) {}
inline std::optional<PointShape> absorbed(const PointShape& point, const Mat4&) { return point; }

}  // namespace orbs::scene

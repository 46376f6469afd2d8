#pragma once

#include "json/writer.h"
#include "scene/lights/placement.h"
#include "scene/lights/without_area.h"

namespace orbs::scene {

/// Parallel light from afar that shines along local -Y: everywhere the same irradiance on a plane across it.
struct DirectionalShape {
  static constexpr const char* kType = "directional";
  static constexpr const char* kRequirement = "D3";
  static constexpr const char* kWhat = "directional";
  static constexpr const char* kEmission = "irradiance";
  static constexpr bool kHasArea = false;
  static constexpr int kPowerOfScale = 0;
  bool operator==(const DirectionalShape&) const = default;
};

inline void load(json::ObjectReader&, DirectionalShape&) {}
inline void write(json::Writer&, const DirectionalShape&) {}

inline std::optional<DirectionalShape> absorbed(const DirectionalShape& light, const Mat4& matrix) {
  return stays_level(matrix) ? std::optional(light) : std::nullopt;
}

}  // namespace orbs::scene

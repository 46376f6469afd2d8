#pragma once

#include "scene/shapes/shape_type.h"

namespace orbs::scene {

/// y < 0. It has no end, so that it stands only where another solid bounds it.
struct HalfSpaceForm {
  static constexpr const char* kType = "half_space";
  static constexpr const char* kWhat = "a half-space";
  static constexpr const char* kLevel = "S4";
  bool operator==(const HalfSpaceForm&) const = default;
};

inline void load(ShapeEntry&, HalfSpaceForm&) {}
inline void write(json::Writer&, const MaterialList&, const HalfSpaceForm&) {}
inline bool is_closed(const HalfSpaceForm&) { return true; }
inline std::optional<LocalBox> bounds(const HalfSpaceForm&) { return std::nullopt; }
inline std::optional<Mesh> tessellated(const HalfSpaceForm&) { return std::nullopt; }

}  // namespace orbs::scene

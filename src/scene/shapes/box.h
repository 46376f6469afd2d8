#pragma once

#include "scene/shapes/shape_type.h"

namespace orbs::scene {

/// About the origin.
struct BoxForm {
  static constexpr const char* kType = "box";
  static constexpr const char* kWhat = "a box";
  static constexpr const char* kLevel = "S1";
  Vec3d half_sizes_m{1, 1, 1};
  bool operator==(const BoxForm&) const = default;
};

void load(ShapeEntry& entry, BoxForm& loaded);
void write(json::Writer& out, const MaterialList& materials, const BoxForm& form);
inline bool is_closed(const BoxForm&) { return true; }
std::optional<LocalBox> bounds(const BoxForm& form);
std::optional<Mesh> tessellated(const BoxForm& form);

}  // namespace orbs::scene

#pragma once

#include "scene/shapes/shape_type.h"

namespace orbs::scene {

/// y = 0, normal +y; it has no inside.
struct DiskForm {
  static constexpr const char* kType = "disk";
  static constexpr const char* kWhat = "a disk";
  static constexpr const char* kLevel = "S1";
  double radius_m = 1;
  bool operator==(const DiskForm&) const = default;
};

void load(ShapeEntry& entry, DiskForm& loaded);
void write(json::Writer& out, const MaterialList& materials, const DiskForm& form);
inline bool is_closed(const DiskForm&) { return false; }
std::optional<LocalBox> bounds(const DiskForm& form);
std::optional<Mesh> tessellated(const DiskForm& form);

}  // namespace orbs::scene

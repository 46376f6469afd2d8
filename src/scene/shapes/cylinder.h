#pragma once

#include "scene/shapes/revolved.h"
#include "scene/shapes/shape_type.h"

namespace orbs::scene {

/// x^2 + z^2 = radius^2 from y = 0 to height; `has_caps`: closed by disks.
struct CylinderForm {
  static constexpr const char* kType = "cylinder";
  static constexpr const char* kWhat = "a cylinder";
  static constexpr const char* kLevel = "S1";
  static constexpr const char* kClosedBy = "\"caps\": true";
  double radius_m = 1;
  double height_m = 1;
  bool has_caps = true;
  bool operator==(const CylinderForm&) const = default;
};

void load(ShapeEntry& entry, CylinderForm& loaded);
void write(json::Writer& out, const MaterialList& materials, const CylinderForm& form);
inline bool is_closed(const CylinderForm& form) { return form.has_caps; }
std::optional<LocalBox> bounds(const CylinderForm& form);
std::optional<Mesh> tessellated(const CylinderForm& form);
RevolvedQuadric revolved(const CylinderForm& form);

}  // namespace orbs::scene

#pragma once

#include "scene/shapes/revolved.h"
#include "scene/shapes/shape_type.h"

namespace orbs::scene {

/// Of one sheet: `radius` at y = 0 and at the height, `waist_radius` half way.
struct HyperboloidForm {
  static constexpr const char* kType = "hyperboloid";
  static constexpr const char* kWhat = "a hyperboloid";
  static constexpr const char* kLevel = "S1";
  static constexpr const char* kClosedBy = "\"caps\": true";
  double radius_m = 1;
  double waist_radius_m = 0.5;
  double height_m = 1;
  bool has_caps = true;
  bool operator==(const HyperboloidForm&) const = default;
};

void load(ShapeEntry& entry, HyperboloidForm& loaded);
void write(json::Writer& out, const MaterialList& materials, const HyperboloidForm& form);
inline bool is_closed(const HyperboloidForm& form) { return form.has_caps; }
std::optional<LocalBox> bounds(const HyperboloidForm& form);
std::optional<Mesh> tessellated(const HyperboloidForm& form);
RevolvedQuadric revolved(const HyperboloidForm& form);

}  // namespace orbs::scene

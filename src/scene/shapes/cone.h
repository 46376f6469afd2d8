#pragma once

#include "scene/shapes/revolved.h"
#include "scene/shapes/shape_type.h"

namespace orbs::scene {

/// The radius falls evenly from `radius` at y = 0 to `top_radius` at the height.
struct ConeForm {
  static constexpr const char* kType = "cone";
  static constexpr const char* kWhat = "a cone";
  static constexpr const char* kLevel = "S1";
  static constexpr const char* kClosedBy = "\"caps\": true";
  double radius_m = 1;
  double top_radius_m = 0;
  double height_m = 1;
  bool has_caps = true;
  bool operator==(const ConeForm&) const = default;
};

void load(ShapeEntry& entry, ConeForm& loaded);
void write(json::Writer& out, const MaterialList& materials, const ConeForm& form);
inline bool is_closed(const ConeForm& form) { return form.has_caps; }
std::optional<LocalBox> bounds(const ConeForm& form);
std::optional<Mesh> tessellated(const ConeForm& form);
RevolvedQuadric revolved(const ConeForm& form);

}  // namespace orbs::scene

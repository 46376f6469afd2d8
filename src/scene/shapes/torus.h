#pragma once

#include "scene/shapes/implicit.h"
#include "scene/shapes/shape_type.h"

namespace orbs::scene {

/// The ring lies in the xz plane.
struct TorusForm {
  static constexpr const char* kType = "torus";
  static constexpr const char* kWhat = "a torus";
  static constexpr const char* kLevel = "S2";
  double major_radius_m = 1;
  double minor_radius_m = 0.25;
  bool operator==(const TorusForm&) const = default;
};

void load(ShapeEntry& entry, TorusForm& loaded);
void write(json::Writer& out, const MaterialList& materials, const TorusForm& form);
inline bool is_closed(const TorusForm&) { return true; }
std::optional<LocalBox> bounds(const TorusForm& form);
std::optional<Mesh> tessellated(const TorusForm& form);
ImplicitForm implicit(const TorusForm& form);

}  // namespace orbs::scene

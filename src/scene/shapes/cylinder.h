#pragma once

#include "json/writer.h"
#include "scene/load/entry.h"
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

inline bool is_closed(const CylinderForm& form) { return form.has_caps; }

inline void load(ShapeEntry& entry, CylinderForm& loaded) {
  loaded.radius_m = entry.in.number("radius", kLength);
  loaded.height_m = entry.in.number("height", kLength);
  loaded.has_caps = load_caps(entry);
}

inline void write(json::Writer& out, const MaterialList&, const CylinderForm& form) {
  out.member("radius", form.radius_m).member("height", form.height_m).member("caps", form.has_caps);
}

inline std::optional<LocalBox> bounds(const CylinderForm& form) {
  return about_axis(form.radius_m, 0, form.height_m);
}

inline RevolvedQuadric revolved(const CylinderForm& form) {
  return {form.radius_m * form.radius_m, 0, 0, 0, form.height_m, form.has_caps};
}

inline std::optional<Mesh> tessellated(const CylinderForm& form) { return turned(revolved(form), 1); }

}  // namespace orbs::scene

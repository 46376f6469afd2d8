#pragma once

#include "json/writer.h"
#include "scene/load/entry.h"
#include "scene/shapes/revolved.h"
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

inline bool is_closed(const DiskForm&) { return false; }

inline void load(ShapeEntry& entry, DiskForm& loaded) {
  loaded.radius_m = entry.in.number("radius", kLength);
}

inline void write(json::Writer& out, const MaterialList&, const DiskForm& form) {
  out.member("radius", form.radius_m);
}

inline std::optional<LocalBox> bounds(const DiskForm& form) { return about_axis(form.radius_m, 0, 0); }

inline std::optional<Mesh> tessellated(const DiskForm& form) {
  Mesh mesh;
  add_cap(mesh, 0, form.radius_m, true);
  return mesh;
}

}  // namespace orbs::scene

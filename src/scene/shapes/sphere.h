#pragma once

#include "json/writer.h"
#include "scene/geometry/generators.h"
#include "scene/load/entry.h"
#include "scene/shapes/revolved.h"
#include "scene/shapes/shape_type.h"

namespace orbs::scene {

struct SphereForm {
  static constexpr const char* kType = "sphere";
  static constexpr const char* kWhat = "an ellipsoid";
  static constexpr const char* kLevel = "S1";
  Vec3d centre_m;
  double radius_m = 1;
  bool operator==(const SphereForm&) const = default;
};

inline bool is_closed(const SphereForm&) { return true; }

inline void load(ShapeEntry& entry, SphereForm& loaded) {
  loaded.centre_m = entry.in.vec3("centre", kPlace);
  loaded.radius_m = entry.in.number("radius", kLength);
}

inline void write(json::Writer& out, const MaterialList&, const SphereForm& form) {
  out.member("centre", form.centre_m).member("radius", form.radius_m);
}

inline std::optional<LocalBox> bounds(const SphereForm& form) {
  const Vec3d r{form.radius_m, form.radius_m, form.radius_m};
  return LocalBox{form.centre_m - r, form.centre_m + r};
}

inline std::optional<Mesh> tessellated(const SphereForm& form) {
  Mesh mesh = make_sphere({form.radius_m, kShapeSegments});
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const std::size_t band = i / (kShapeSegments + 1);
    mesh.uvs[i].y = 1 - static_cast<float>(band) / kShapeBands;
    mesh.positions[i] = cast<float>(cast<double>(mesh.positions[i]) + form.centre_m);
  }
  return mesh;
}

}  // namespace orbs::scene

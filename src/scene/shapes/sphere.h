#pragma once

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

void load(ShapeEntry& entry, SphereForm& loaded);
void write(json::Writer& out, const MaterialList& materials, const SphereForm& form);
inline bool is_closed(const SphereForm&) { return true; }
std::optional<LocalBox> bounds(const SphereForm& form);
std::optional<Mesh> tessellated(const SphereForm& form);

}  // namespace orbs::scene

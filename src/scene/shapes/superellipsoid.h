#pragma once

#include "scene/shapes/implicit.h"
#include "scene/shapes/shape_type.h"

namespace orbs::scene {

/// (|x|^(2/e) + |z|^(2/e))^(e/n) + |y|^(2/n) = 1 with e = east_west, n = north_south (Barr 1981,
/// Superquadrics and Angle-Preserving Transformations).
struct SuperellipsoidForm {
  static constexpr const char* kType = "superellipsoid";
  static constexpr const char* kWhat = "a superellipsoid";
  static constexpr const char* kLevel = "S2";
  double east_west = 1;
  double north_south = 1;
  bool operator==(const SuperellipsoidForm&) const = default;
};

void load(ShapeEntry& entry, SuperellipsoidForm& loaded);
void write(json::Writer& out, const MaterialList& materials, const SuperellipsoidForm& form);
inline bool is_closed(const SuperellipsoidForm&) { return true; }
std::optional<LocalBox> bounds(const SuperellipsoidForm& form);
std::optional<Mesh> tessellated(const SuperellipsoidForm& form);
ImplicitForm implicit(const SuperellipsoidForm& form);

}  // namespace orbs::scene

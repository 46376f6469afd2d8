#pragma once

#include "scene/shapes/revolved.h"
#include "scene/shapes/shape_type.h"

namespace orbs::scene {

/// y = height (x^2 + z^2) / radius^2 up to the height.
struct ParaboloidForm {
  static constexpr const char* kType = "paraboloid";
  static constexpr const char* kWhat = "a paraboloid";
  static constexpr const char* kLevel = "S1";
  static constexpr const char* kClosedBy = "\"caps\": true";
  double radius_m = 1;
  double height_m = 1;
  bool has_caps = true;
  bool operator==(const ParaboloidForm&) const = default;
};

void load(ShapeEntry& entry, ParaboloidForm& loaded);
void write(json::Writer& out, const MaterialList& materials, const ParaboloidForm& form);
inline bool is_closed(const ParaboloidForm& form) { return form.has_caps; }
std::optional<LocalBox> bounds(const ParaboloidForm& form);
std::optional<Mesh> tessellated(const ParaboloidForm& form);
RevolvedQuadric revolved(const ParaboloidForm& form);

}  // namespace orbs::scene

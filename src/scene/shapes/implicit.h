#pragma once

#include "scene/shapes/expression.h"
#include "scene/shapes/shape_type.h"

namespace orbs::scene {

/// f = 0 within a box; inside is f < 0. Closed: the solid f <= 0 is cut by the box, whose faces belong to it.
struct ImplicitForm {
  static constexpr const char* kType = "implicit";
  static constexpr const char* kWhat = "an implicit surface";
  static constexpr const char* kLevel = "S3";
  static constexpr const char* kClosedBy = "\"closed\": true";
  Expression expression;
  Vec3d low_m;
  Vec3d high_m;
  bool is_closed = false;
  bool operator==(const ImplicitForm&) const = default;
};

void load(ShapeEntry& entry, ImplicitForm& loaded);
void write(json::Writer& out, const MaterialList& materials, const ImplicitForm& form);
inline bool is_closed(const ImplicitForm& form) { return form.is_closed; }
inline std::optional<LocalBox> bounds(const ImplicitForm& form) { return LocalBox{form.low_m, form.high_m}; }
inline std::optional<Mesh> tessellated(const ImplicitForm&) { return std::nullopt; }
inline ImplicitForm implicit(const ImplicitForm& form) { return form; }

}  // namespace orbs::scene

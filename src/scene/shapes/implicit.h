#pragma once

#include "base/error.h"
#include "json/writer.h"
#include "scene/load/entry.h"
#include "scene/shapes/expression.h"
#include "scene/shapes/formula_range.h"
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

inline bool is_closed(const ImplicitForm& form) { return form.is_closed; }
inline std::optional<LocalBox> bounds(const ImplicitForm& form) { return LocalBox{form.low_m, form.high_m}; }
inline std::optional<Mesh> tessellated(const ImplicitForm&) { return std::nullopt; }
inline ImplicitForm implicit(const ImplicitForm& form) { return form; }

inline void load(ShapeEntry& entry, ImplicitForm& loaded) {
  auto& in = entry.in;
  try {
    loaded.expression = parse_expression(in.text("expression"));
  } catch (const InputError& e) {
    in.fail("expression", e.what());
  }
  loaded.low_m = in.vec3("low", kPlace);
  loaded.high_m = in.vec3("high", kPlace);
  const Vec3d low = loaded.low_m;
  const Vec3d high = loaded.high_m;
  if (!(low.x < high.x && low.y < high.y && low.z < high.z))
    in.fail("high", "must be above low in x, y and z");
  if (!has_values(loaded.expression, low, high))
    in.fail(
        "expression",
        "has no finite value anywhere in its box, as x / 0 has none: write a formula that is finite where its "
        "surface lies");
  loaded.is_closed = in.boolean_or("closed", false);
}

inline void write(json::Writer& out, const MaterialList&, const ImplicitForm& form) {
  out.member("expression", form.expression.text);
  out.member("low", form.low_m).member("high", form.high_m).member("closed", form.is_closed);
}

}  // namespace orbs::scene

#include "scene/shapes/implicit.h"

#include "base/error.h"
#include "json/writer.h"
#include "scene/load/entry.h"
#include "scene/shapes/expression.h"

namespace orbs::scene {

void load(ShapeEntry& entry, ImplicitForm& loaded) {
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
  loaded.is_closed = in.boolean_or("closed", false);
}

void write(json::Writer& out, const MaterialList&, const ImplicitForm& form) {
  out.member("expression", form.expression.text);
  out.member("low", form.low_m).member("high", form.high_m).member("closed", form.is_closed);
}

}  // namespace orbs::scene

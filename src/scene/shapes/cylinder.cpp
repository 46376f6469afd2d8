#include "scene/shapes/cylinder.h"

#include "json/writer.h"
#include "scene/load/entry.h"

namespace orbs::scene {

void load(ShapeEntry& entry, CylinderForm& loaded) {
  loaded.radius_m = entry.in.number("radius", kLength);
  loaded.height_m = entry.in.number("height", kLength);
  loaded.has_caps = load_caps(entry);
}

void write(json::Writer& out, const MaterialList&, const CylinderForm& form) {
  out.member("radius", form.radius_m).member("height", form.height_m).member("caps", form.has_caps);
}

std::optional<LocalBox> bounds(const CylinderForm& form) {
  return about_axis(form.radius_m, 0, form.height_m);
}

RevolvedQuadric revolved(const CylinderForm& form) {
  return {form.radius_m * form.radius_m, 0, 0, 0, form.height_m, form.has_caps};
}

std::optional<Mesh> tessellated(const CylinderForm& form) { return turned(revolved(form), 1); }

}  // namespace orbs::scene

#include "scene/shapes/disk.h"

#include "json/writer.h"
#include "scene/load/entry.h"
#include "scene/shapes/revolved.h"

namespace orbs::scene {

void load(ShapeEntry& entry, DiskForm& loaded) { loaded.radius_m = entry.in.number("radius", kLength); }

void write(json::Writer& out, const MaterialList&, const DiskForm& form) {
  out.member("radius", form.radius_m);
}

std::optional<LocalBox> bounds(const DiskForm& form) { return about_axis(form.radius_m, 0, 0); }

std::optional<Mesh> tessellated(const DiskForm& form) {
  Mesh mesh;
  add_cap(mesh, 0, form.radius_m, true);
  return mesh;
}

}  // namespace orbs::scene

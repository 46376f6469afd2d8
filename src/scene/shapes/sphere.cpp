#include "scene/shapes/sphere.h"

#include "json/writer.h"
#include "scene/geometry/generators.h"
#include "scene/load/entry.h"
#include "scene/shapes/revolved.h"

namespace orbs::scene {

void load(ShapeEntry& entry, SphereForm& loaded) {
  loaded.centre_m = entry.in.vec3("centre", kPlace);
  loaded.radius_m = entry.in.number("radius", kLength);
}

void write(json::Writer& out, const MaterialList&, const SphereForm& form) {
  out.member("centre", form.centre_m).member("radius", form.radius_m);
}

std::optional<LocalBox> bounds(const SphereForm& form) {
  const Vec3d r{form.radius_m, form.radius_m, form.radius_m};
  return LocalBox{form.centre_m - r, form.centre_m + r};
}

std::optional<Mesh> tessellated(const SphereForm& form) {
  Mesh mesh = make_sphere({form.radius_m, kShapeSegments});
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const std::size_t band = i / (kShapeSegments + 1);
    mesh.uvs[i].y = 1 - static_cast<float>(band) / kShapeBands;
    mesh.positions[i] = cast<float>(cast<double>(mesh.positions[i]) + form.centre_m);
  }
  return mesh;
}

}  // namespace orbs::scene

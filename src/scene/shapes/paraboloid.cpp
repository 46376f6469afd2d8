#include "scene/shapes/paraboloid.h"

#include "json/writer.h"
#include "scene/load/entry.h"

namespace orbs::scene {

void load(ShapeEntry& entry, ParaboloidForm& loaded) {
  loaded.radius_m = entry.in.number("radius", kLength);
  loaded.height_m = entry.in.number("height", kLength);
  loaded.has_caps = load_caps(entry);
}

void write(json::Writer& out, const MaterialList&, const ParaboloidForm& form) {
  out.member("radius", form.radius_m).member("height", form.height_m).member("caps", form.has_caps);
}

std::optional<LocalBox> bounds(const ParaboloidForm& form) {
  return about_axis(form.radius_m, 0, form.height_m);
}

RevolvedQuadric revolved(const ParaboloidForm& form) {
  return {0, form.radius_m * form.radius_m / form.height_m, 0, 0, form.height_m, form.has_caps};
}

std::optional<Mesh> tessellated(const ParaboloidForm& form) {
  std::vector<double> heights;  // of even radii
  for (int i = kShapeBands; i >= 0; --i)
    heights.push_back(form.height_m * i * i / (kShapeBands * kShapeBands));
  return turned(revolved(form), heights);
}

}  // namespace orbs::scene

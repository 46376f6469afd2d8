#include "scene/load_parts.h"

namespace orbs::scene {

Sphere load_shape(json::ObjectReader in, const Names& materials) {
  in.one_of("type", {"sphere"});
  Sphere sphere;
  sphere.name = in.text_or("name", "");
  sphere.centre_m = in.vec3("centre", kPlace);
  sphere.radius_m = in.number("radius", kLength);
  sphere.material = materials.find(in, "material");
  in.finish();
  return sphere;
}

}  // namespace orbs::scene

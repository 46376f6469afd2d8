#include "scene/relations/surface.h"

#include "scene/geometry/generators.h"
#include "scene/geometry/world_bounds.h"

namespace orbs::scene {

std::variant<Scene, std::string> with_clear_box(const Scene& scene) {
  const auto drawn = world_bounds(scene);
  if (!drawn) return "it is empty";
  const auto& camera = scene.camera;
  auto all = joined(*drawn, {camera.position_m, camera.position_m});
  if (camera.end) all = joined(all, {camera.end->position_m, camera.end->position_m});
  Scene out = scene;
  Material clear{"clear", Lambert{}};
  clear.detail.opacity = 0;
  out.materials.push_back(std::move(clear));
  Mesh box = make_cube({0.5});
  box.name = "clear box";
  box.triangle_materials.assign(box.triangles.size(), static_cast<int>(out.materials.size()) - 1);
  out.meshes.push_back(std::move(box));
  // Twice the diameter on each side: lenses and the planes of orthographic cameras lie inside, too.
  const double side = 4 * radius_of(all);
  out.instances.push_back({"clear box",
                           static_cast<int>(out.meshes.size()) - 1,
                           translation((all.low + all.high) * 0.5) * scaling({side, side, side}),
                           {}});
  return out;
}

}  // namespace orbs::scene

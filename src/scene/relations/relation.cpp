#include "scene/relations/relation.h"

#include "scene/lower/geometry.h"
#include "scene/motion.h"
#include "scene/relations/geometry.h"
#include "scene/relations/ground.h"
#include "scene/relations/light.h"
#include "scene/relations/motion.h"
#include "scene/relations/surface.h"

#include <utility>

namespace orbs::scene {

namespace {

using Changed = std::variant<Scene, std::string>;

// The original scene and a changed one, or the reason of the change that could not be made.
Related related(const Scene& original, Changed changed, RelatedImage image = SameImage{}) {
  if (auto* reason = std::get_if<std::string>(&changed)) return std::move(*reason);
  return RelatedScenes{original, std::get<Scene>(std::move(changed)), image};
}

// Both scenes are made by the same change, with different magnitudes.
Related between(Changed first, Changed second) {
  if (auto* reason = std::get_if<std::string>(&first)) return std::move(*reason);
  return related(std::get<Scene>(first), std::move(second));
}

Related turned(const Scene& scene, const Mat4& motion, RelatedImage image = SameImage{}) {
  if (auto problem = turning_problem(scene); !problem.empty()) return problem;
  return RelatedScenes{scene, moved(scene, motion), image};
}

constexpr const char* kCameraMoves = "its camera moves";
constexpr const char* kMoves = "something moves, and one mesh in world space cannot";

// A unit vector off all axes, with short decimal numbers.
constexpr Vec3d kDirection{0.6, 0.48, 0.64};

Related translate_matrix(const Scene& scene, double metres) {
  return RelatedScenes{scene, moved(scene, translation(kDirection * metres)), SameImage{}};
}
Related translate_vertices(const Scene& scene, double metres) {
  if (has_moving_objects(scene)) return kMoves;
  return RelatedScenes{with_moved_vertices(scene, {}), with_moved_vertices(scene, kDirection * metres),
                       SameImage{}};
}
Related scale(const Scene& scene, double factor) {
  return RelatedScenes{scene, moved(scene, scaling({factor, factor, factor})), SameImage{}};
}
Related ground(const Scene& scene, double ratio) {
  constexpr double kSmallest = 100;
  return between(with_large_ground(scene, kSmallest), with_large_ground(scene, ratio));
}
Related camera_distance(const Scene& scene, double factor) {
  // From there on the perspective changes by less than a thousandth of the image.
  constexpr double kNearest = 1000;
  if (scene.camera.end) return kCameraMoves;
  return between(with_far_camera(scene, kNearest), with_far_camera(scene, factor));
}
Related gap(const Scene& scene, double metres) {
  return related(scene, with_sheet_below_ground(scene, metres));
}
Related rotate(const Scene& scene, double) {
  return turned(scene, rotation_x(23) * rotation_y(37) * rotation_z(11));
}
Related mirror(const Scene& scene, double) { return turned(scene, scaling({-1, 1, 1}), MirroredImage{}); }
Related triangle_order(const Scene& scene, double) { return related(scene, with_triangles_reversed(scene)); }
Related object_order(const Scene& scene, double) {
  if (scene.instances.size() + scene.spheres.size() + scene.shapes.size() < 2) return "it has one object";
  return related(scene, with_objects_reversed(scene));
}
Related light_order(const Scene& scene, double) {
  if (scene.lights.size() < 2) return "it has no two lights";
  return related(scene, with_lights_reversed(scene));
}
Related split_triangles(const Scene& scene, double) { return related(scene, with_triangles_split(scene)); }
Related split_emitters(const Scene& scene, double) { return related(scene, with_emitters_split(scene)); }
Related winding(const Scene& scene, double) { return related(scene, with_windings_flipped(scene)); }
Related emission(const Scene& scene, double factor) {
  return related(scene, with_emission_times(scene, factor), MultipliedImage{factor});
}
Related channels(const Scene& scene, double) {
  return related(scene, with_rotated_channels(scene), RotatedChannels{});
}
Related unreachable(const Scene& scene, double) {
  // Behind the camera at the start of the frame it may be before the camera later.
  if (scene.camera.end) return kCameraMoves;
  return related(scene, with_unreachable_object(scene));
}
Related clear_box(const Scene& scene, double) { return related(scene, with_clear_box(scene)); }
Related blend_of_itself(const Scene& scene, double) {
  return related(scene, with_blends_of_themselves(scene));
}
Related second_coordinates(const Scene& scene, double) {
  return related(scene, with_second_coordinates(scene));
}
Related small_lens(const Scene& scene, double share) { return related(scene, with_small_lens(scene, share)); }
Related points_as_spots(const Scene& scene, double) { return related(scene, with_points_as_spots(scene)); }
Related points_as_spheres(const Scene& scene, double share) {
  return related(scene, with_points_as_spheres(scene, share));
}
Related copies(const Scene& scene, double) {
  if (has_moving_objects(scene)) return kMoves;
  Scene world = scene;
  merge_into_world_mesh(world);
  if (world.instances.empty()) return "it has no instances";
  return related(scene, std::move(world));
}

const std::vector<double> kOne{1};
const std::vector<double> kUp{1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};
const std::vector<double> kDown{1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9};

std::vector<Relation> all_relations() {
  return {
      {"translate_matrix", "the world moved, by its matrices", "m", kUp, false, translate_matrix},
      {"translate_vertices", "the world moved, by its vertices in double", "m", kUp, false,
       translate_vertices},
      {"scale_up", "the world enlarged", "", kUp, false, scale},
      {"scale_down", "the world made smaller", "", kDown, false, scale},
      {"ground",
       "a larger ground, times the other objects",
       "",
       {1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9},
       false,
       ground},
      {"camera_distance", "a more distant camera", "", {3e3, 1e4, 3e4, 1e5}, false, camera_distance},
      {"gap",
       "a hidden sheet closer below the ground",
       "m",
       {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9},
       false,
       gap},
      {"emission_up",
       "emission times a power of two",
       "",
       {0x1p10, 0x1p20, 0x1p30, 0x1p40, 0x1p60, 0x1p80},
       true,
       emission},
      {"emission_down",
       "emission times a power of two below 1",
       "",
       {0x1p-10, 0x1p-20, 0x1p-30, 0x1p-40, 0x1p-60, 0x1p-80},
       true,
       emission},
      {"rotate", "world and camera turned", "", kOne, false, rotate},
      {"mirror", "world and camera mirrored", "", kOne, false, mirror},
      {"triangle_order", "triangles in reverse order", "", kOne, false, triangle_order},
      {"object_order", "objects in reverse order", "", kOne, false, object_order},
      {"light_order", "lights in reverse order", "", kOne, false, light_order},
      {"split_triangles", "each triangle as four", "", kOne, false, split_triangles},
      {"split_emitters", "each emitter as four", "", kOne, false, split_emitters},
      {"points_as_spots", "each point of light as two spots", "", kOne, false, points_as_spots},
      {"points_as_spheres",
       "each point of light as a small sphere, times the scene",
       "",
       {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9},
       false,
       points_as_spheres},
      {"clear_box", "a box around all of opacity 0", "", kOne, false, clear_box},
      {"blend_of_itself", "each material as a blend of itself", "", kOne, false, blend_of_itself},
      {"second_coordinates", "textures at second coordinates", "", kOne, false, second_coordinates},
      {"small_lens",
       "a small lens, times the distance in focus",
       "",
       {1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9},
       false,
       small_lens},
      {"winding", "windings and normals flipped", "", kOne, false, winding},
      {"channels", "colour channels exchanged", "", kOne, false, channels},
      {"unreachable", "an object more that no path reaches", "", kOne, false, unreachable},
      {"copies", "copies instead of instances", "", kOne, false, copies},
  };
}

}  // namespace

const std::vector<Relation>& relations() {
  static const std::vector<Relation> kAll = all_relations();
  return kAll;
}

bool is_sweep(const std::vector<double>& magnitudes) { return magnitudes != std::vector<double>{1}; }

}  // namespace orbs::scene

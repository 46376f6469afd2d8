#pragma once

#include "base/vec.h"
#include "scene/scene.h"

#include <optional>
#include <vector>

namespace orbs::scene {

/// Vertices of a mesh as floats, relative to an origin.
struct PlacedVertices {
  std::vector<Vec3f> positions;
  Vec3d origin_m;
};

/// Vertices as a file gives them. The origin is zero, and each number is rounded to the nearest float, unless
/// the mesh lies farther out than 64 times its extent: floats would then round away more than 4e-6 of the
/// extent. The origin is then a place in the mesh to which doubles subtract exactly (Sterbenz' lemma for
/// vertices that floats or doubles of the file's size hold).
PlacedVertices placed_vertices(const std::vector<Vec3d>& vertices);

/// A box along the axes of the world.
struct WorldBounds {
  Vec3d low;
  Vec3d high;
};

inline double radius_of(const WorldBounds& bounds) { return 0.5 * length(bounds.high - bounds.low); }

/// The box around the vertices of an instance, which has at least one; where it moves, of the whole frame.
WorldBounds world_bounds(const Scene& scene, const Instance& instance);

WorldBounds joined(const WorldBounds& a, const WorldBounds& b);

/// The box around all that is drawn; of lights, around the box of their shape. Nothing if nothing is drawn.
std::optional<WorldBounds> world_bounds(const Scene& scene);

/// A box around that one, not more than about twice as large: around the boxes of the meshes along their own
/// axes. Its time does not grow with the product of instances and vertices.
std::optional<WorldBounds> rough_bounds(const Scene& scene);

/// For each instance and each light, whether it is more than `ratio` times as large as all that is smaller,
/// the camera included: the ground, the walls or the sky around a small scene.
struct VastObjects {
  std::vector<bool> instances;
  std::vector<bool> lights;
};
VastObjects vast_objects(const Scene& scene, double ratio);

}  // namespace orbs::scene

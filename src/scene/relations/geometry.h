#pragma once

#include "scene/scene.h"

#include <string>
#include <variant>

/// Changes of how surfaces are stored that change nothing of what is drawn.

namespace orbs::scene {

/// The power of two by which all lengths are multiplied so that the radius of what is drawn, with the camera,
/// is at least `least_radius_m` and at most `most_radius_m`, which must be twice as large or more; 1 where it
/// is. Floats are multiplied by it without rounding.
double rescaling_into(const Scene& scene, double least_radius_m, double most_radius_m);

/// The triangles of every mesh in reverse order.
Scene with_triangles_reversed(const Scene& scene);

/// Instances and shapes in reverse order.
Scene with_objects_reversed(const Scene& scene);

Scene with_lights_reversed(const Scene& scene);

/// Every triangle of a mesh without smooth normals, and without emission, as the four of its edges' middles.
/// Neighbours share the middle, so no T-junctions arise. Smooth meshes stay: the vertex normal at a middle
/// would have to be unit, which changes what is interpolated. The reason if no mesh can be split.
std::variant<Scene, std::string> with_triangles_split(const Scene& scene);

/// Meshes with emission are split likewise, and rectangular lights without a profile become four of a quarter
/// of the area; lights without an area become two of half the power. The reason if the scene has none of
/// them.
std::variant<Scene, std::string> with_emitters_split(const Scene& scene);

/// Every triangle with its corners in reverse order; where all materials of a mesh are opaque and the same
/// from both sides, also with reversed vertex normals.
Scene with_windings_flipped(const Scene& scene);

/// With a small black cube where no path ends that carries light: three times as far behind the camera as the
/// farthest object. The reason if the environment shines.
std::variant<Scene, std::string> with_unreachable_object(const Scene& scene);

}  // namespace orbs::scene

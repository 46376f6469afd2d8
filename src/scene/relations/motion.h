#pragma once

#include "scene/scene.h"

#include <string>

/// Motions of the whole world with its camera.
namespace orbs::scene {

/// The scene with instances, shapes, lights and camera moved by `motion`, which must be a similarity: a
/// rotation or reflection, a uniform scale, and a translation. Radiance stays, as it does along rays in a
/// vacuum, and irradiance across parallel light; intensities of points follow the square of the scale.
/// Heights of thin films stay, because their phase depends on the angle alone.
Scene moved(const Scene& scene, const Mat4& motion);

/// Why a motion that turns the world changes the image; "" if it does not. Texture coordinates of spheres
/// follow the axes of the world.
std::string turning_problem(const Scene& scene);

/// The scene with all meshes in world space, moved by `offset` with all else: as a scene whose file holds the
/// moved vertices in double.
Scene with_moved_vertices(const Scene& scene, Vec3d offset);

}  // namespace orbs::scene

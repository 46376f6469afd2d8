#pragma once

#include "scene/scene.h"

#include <string>

/// Motion within a frame. All of it is linear in time, as in Embree: at the time t, 0 at the start of the
/// frame and 1 at its end, the matrix of an instance is (1 - t) times the one of the start plus t times the
/// one of the end, entry by entry, and so are the positions and normals of the vertices of a mesh, and the
/// position of the camera, the point that it looks at and its up direction. A vertex whose mesh keeps its
/// shape moves on a straight line at constant speed, also where the matrices turn it. Normals are those of
/// the vertices at the time, by the inverse transpose of the matrix at the time.
namespace orbs::scene {

/// Whether something about the instance changes within the frame.
bool is_moving(const Scene& scene, const Instance& instance);

/// Whether an instance changes while the shutter is open.
bool has_moving_objects(const Scene& scene);

/// Whether something changes while the shutter is open, the camera included. Scenes of load_scene hold no
/// motion otherwise.
bool has_motion(const Scene& scene);

Mat4 matrix_at(const Instance& instance, double time);

/// The camera at rest as it is at this time.
Camera camera_at(const Camera& camera, double time);

/// The scene at rest as it is at this time.
Scene at_time(const Scene& scene, double time);

/// Drops motion that leads nowhere, and all of it where the shutter shows an instant: the scene is then at
/// rest at that time.
void drop_unseen_motion(Scene& scene);

/// The complaint about two matrices between which one is singular; "" when there is none.
std::string motion_problem(const Mat4& start, const Mat4& end);

/// The complaint about a camera that has no view at some time on its way; "" when there is none. The start is
/// right.
std::string motion_problem(const Camera& camera);

/// Whether what lies between two vectors comes so near to zero that floats do not tell its direction.
bool meets_zero(Vec3d from, Vec3d to);

}  // namespace orbs::scene

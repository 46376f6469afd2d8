#pragma once

#include "scene/scene.h"
#include "tracer/world/camera.h"

namespace orbs::tracer {

/// What must be resolved: all that is drawn and the camera, or without it where it is far away.
struct Extent {
  Vec3d centre;  // the camera's position, or the middle of what is drawn for a distant camera
  double radius_m = 0;
  bool camera_is_distant = false;  // wherever it is within the frame
};

Extent extent_of(const scene::Scene& scene);

/// Origin of the world's coordinates. At 10^7 m from their origin floats are 1 m apart, so the origin is
/// placed near the camera: at the scene's own, or a multiple of a step from there, which doubles subtract
/// exactly.
Vec3d origin_near(const Extent& extent);

/// Of a camera at rest, with coordinates relative to the origin.
PinholeCamera prepare_camera(const scene::Camera& camera, const Extent& extent, Vec3d origin);

/// What the camera is prepared from for each path anew where it moves.
struct MovingCamera {
  scene::Camera camera;
  Extent extent;
  Vec3d origin;
};

/// The camera at this time, for an image of the size of `start`.
PinholeCamera camera_at(const MovingCamera& moving, const PinholeCamera& start, float time);

}  // namespace orbs::tracer

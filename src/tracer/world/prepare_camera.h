#pragma once

#include "scene/geometry/extent.h"
#include "scene/scene.h"
#include "tracer/world/camera.h"

namespace orbs::tracer {

/// Of a camera at rest, with coordinates relative to the origin.
Camera prepare_camera(const scene::Camera& camera, const scene::Extent& extent, Vec3d origin);

/// What the camera is prepared from for each path anew where it moves.
struct MovingCamera {
  scene::Camera camera;
  scene::Extent extent;
  Vec3d origin;
};

/// The camera at this time, for an image of the size of `start`.
Camera camera_at(const MovingCamera& moving, const Camera& start, float time);

}  // namespace orbs::tracer

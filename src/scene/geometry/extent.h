#pragma once

#include "scene/scene.h"

namespace orbs::scene {

/// What must be resolved: all that is drawn and the camera, or without it where it is far away.
struct Extent {
  Vec3d centre;  // the camera's position, or the middle of what is drawn for a distant camera
  double radius_m = 0;
  bool camera_is_distant = false;  // wherever it is within the frame
};

Extent extent_of(const Scene& scene);

/// An origin of coordinates from which floats resolve the scene. At 10^7 m from their origin floats are 1 m
/// apart, so it is placed near the camera: at the scene's own, or a multiple of the step from there, which
/// doubles subtract exactly. A step of four to eight radii leaves the origin of a scene that contains it
/// where it is, as the camera is then within two radii of it, and no coordinate of a scene elsewhere is above
/// six: its roundings stay below 6 * 2^-24 of the radius. The step is 256 m at most, half of which floats
/// resolve to 8e-6 m.
Vec3d origin_near(const Extent& extent);

}  // namespace orbs::scene

#pragma once

#include "scene/projections/frame.h"

namespace orbs::scene {

/// All rays are parallel to the view direction and begin in the plane of the camera.
struct Orthographic {
  static constexpr const char* kType = "orthographic";
  static constexpr const char* kLevel = "C2";
  static constexpr const char* kWhat = "orthographic";
  double height_m = 1;  // of the image; its width follows from the pixels
  bool operator==(const Orthographic&) const = default;
};

inline CameraRay ray_at(const Orthographic&, const CameraFrame& frame, Vec3d eye_m, double x, double y) {
  return {eye_m + frame.right * x + frame.up * y, frame.forward};
}

inline void scale(Orthographic& projection, double factor) { projection.height_m *= factor; }

}  // namespace orbs::scene

#pragma once

#include "scene/projections/frame.h"

namespace orbs::scene {

/// glFrustum: straight lines stay straight, and what is twice as far is half as large. The field of view, the
/// lens and its shift are the camera's own (Camera).
struct Perspective {
  static constexpr const char* kType = "perspective";
  static constexpr const char* kLevel = "";  // ORB.S REQ_G2
  static constexpr const char* kWhat = "a perspective";
  bool operator==(const Perspective&) const = default;
};

/// Through the point of the window, in units of CameraFrame: of a lens the ray through its middle. The
/// direction is 1 along `forward`.
inline CameraRay ray_at(const Perspective&, const CameraFrame& frame, Vec3d eye_m, double x, double y) {
  return {eye_m, frame.forward + frame.right * x + frame.up * y};
}

inline void scale(Perspective&, double) {}

}  // namespace orbs::scene

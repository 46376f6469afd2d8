#pragma once

#include "scene/projections/frame.h"

#include <cmath>

namespace orbs::scene {

/// All directions in one image (equirectangular): its columns are longitudes, from -pi at the left to pi, 0
/// forward and pi / 2 to the right, its rows latitudes, from pi / 2 at the top, upwards, to -pi / 2.
struct LatitudeLongitude {
  static constexpr const char* kType = "latitude_longitude";
  static constexpr const char* kLevel = "C4";
  static constexpr const char* kWhat = "a latitude-longitude image";
  bool operator==(const LatitudeLongitude&) const = default;
};

inline CameraRay ray_at(const LatitudeLongitude&, const CameraFrame& frame, Vec3d eye_m, double x, double y) {
  return {eye_m,
          (frame.forward * std::cos(x) + frame.right * std::sin(x)) * std::cos(y) + frame.up * std::sin(y)};
}

inline void scale(LatitudeLongitude&, double) {}

}  // namespace orbs::scene

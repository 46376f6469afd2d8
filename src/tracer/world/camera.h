#pragma once

#include "tracer/geometry/mirror_plane.h"
#include "tracer/geometry/ray.h"

#include <optional>

namespace orbs::tracer {

/// A camera that is many times farther from the scene than the scene is large. In floats its rays would miss
/// their points by 2^-24 of the distance, so they are computed in double and begin before the scene.
struct DistantCamera {
  Vec3d position;  // and the vectors of PinholeCamera
  Vec3d forward;
  Vec3d right;
  Vec3d up;
  double start_m = 0;  // no surface is nearer to the camera
};

struct PinholeCamera {
  Vec3f position;
  Vec3f forward;  // unit, to the centre of the image plane at distance 1
  Vec3f right;    // half the width of the image plane
  Vec3f up;       // half its height
  int width = 0;  // of the image in pixels
  int height = 0;
  std::optional<DistantCamera> distant{};
};

/// Ray through film position (x, y), in pixels from the upper left corner.
Ray camera_ray(const PinholeCamera& camera, float x, float y);

/// Where the camera sees a point, and the factor from the area of the surface to the mean over the pixel.
struct CameraProjection {
  std::uint32_t pixel = 0;
  float importance = 0;  // per m^2 of surface perpendicular to the ray; 0 outside the image
};

CameraProjection project(const PinholeCamera& camera, Vec3f point);

/// The mirrored camera sees a point where the camera sees its reflection.
PinholeCamera mirrored(const MirrorPlane& plane, const PinholeCamera& camera);

}  // namespace orbs::tracer

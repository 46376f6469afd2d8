#pragma once

#include "scene/scene.h"

namespace orbs::scene {

CameraFrame camera_frame(const Camera& camera);

/// The ray through a point of the image, in pixels from its upper left corner; of a lens the one through its
/// middle. `frame` is that of the camera. The direction is unit but for a perspective, whose is 1 long along
/// the axis.
CameraRay camera_ray(const Camera& camera, const CameraFrame& frame, double x_px, double y_px);

/// Whether the camera maps the world as glFrustum does: a perspective whose window is centred, without a
/// lens.
bool is_plain_pinhole(const Camera& camera);

inline bool has_lens(const Camera& camera) { return camera.aperture_radius_m > 0; }
inline bool is_shifted(const Camera& camera) { return camera.shift != Vec2d{}; }
inline bool is_perspective(const Camera& camera) {
  return std::holds_alternative<Perspective>(camera.projection);
}

}  // namespace orbs::scene

#pragma once

#include "scene/scene.h"

#include <cmath>
#include <numbers>

/// Frames of Stokes vectors. Signs are the same here and in Mitsuba (its documentation, "Polarization"): seen
/// from the camera, S1 > 0 is horizontal, S2 > 0 at +45 degrees, S3 > 0 right-circular; the field of a metal
/// varies as exp(+i w t) there, with n - i k, which comes to the same. Horizontal, however, is the camera's x
/// projected across the ray here, and the direction across both the ray and the camera's y there.

namespace orbs::adapters::mitsuba {

/// Twice this angle moves 1.7 % of S1 to S2 in the corners.
constexpr double kMostFrameTurn_deg = 0.5;

/// The largest angle between the two in the image: with the tangents a and b of a ray's angles to the right
/// and up, sin = a b / sqrt((1 + a^2) (1 + b^2)). It turns S1 and S2 into each other by twice as much.
inline double stokes_frame_turn_deg(const scene::Camera& camera) {
  const double up = std::tan(camera.fov_y_deg * std::numbers::pi / 360);
  const double right = up * camera.width_px / camera.height_px;
  const double sine = right * up / std::sqrt((1 + right * right) * (1 + up * up));
  return std::asin(sine) * 180 / std::numbers::pi;
}

}  // namespace orbs::adapters::mitsuba

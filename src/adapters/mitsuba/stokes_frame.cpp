#include "adapters/mitsuba/stokes_frame.h"

#include <cmath>
#include <numbers>

namespace orbs::adapters::mitsuba {

double stokes_frame_turn_deg(const scene::Camera& camera) {
  const double up = std::tan(camera.fov_y_deg * std::numbers::pi / 360);
  const double right = up * camera.width_px / camera.height_px;
  const double sine = right * up / std::sqrt((1 + right * right) * (1 + up * up));
  return std::asin(sine) * 180 / std::numbers::pi;
}

}  // namespace orbs::adapters::mitsuba

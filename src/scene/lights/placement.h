#pragma once

#include "base/matrix.h"
#include "scene/lights/light_type.h"

#include <optional>

/// What the kinds of lights ask of the matrix that places them.
namespace orbs::scene {

/// Sines and cosines of right angles come out as 6e-17 rather than 0; an entry this small beside the largest
/// one counts as 0.
constexpr double kMatrixRounding = 1e-12;

double largest_entry(const Mat4& matrix);

/// Whether the matrix moves and does nothing else.
bool is_translation(const Mat4& matrix);

/// The factor by which the matrix scales equally in all directions; nothing when it shears or scales
/// unevenly.
std::optional<double> uniform_scale(const Mat4& matrix);

/// Whether X and Z stay in the plane of both and the side of a flat light that shines still faces down.
bool stays_level(const Mat4& matrix);

/// The factor by which the matrix scales X and Z, where it stays level and they keep their right angle and
/// get the same length: what is round stays round, and a rotation about Y does not change it.
std::optional<double> level_scale(const Mat4& matrix);

/// Where a ray meets the part of the local XZ plane in which `is_inside(x, z)`.
template <typename Inside>
LightHit flat_hit(Vec3d o, Vec3d d, const Inside& is_inside) {
  if (d.y == 0) return {};
  const double t = -o.y / d.y;
  return t > 0 && is_inside(o.x + t * d.x, o.z + t * d.z) ? LightHit{t, o.y < 0} : LightHit{};
}

}  // namespace orbs::scene

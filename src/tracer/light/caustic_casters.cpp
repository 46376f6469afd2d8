#include "tracer/light/caustic_casters.h"

#include "tracer/geometry/transforms.h"
#include "tracer/sampling/warps.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace orbs::tracer {

namespace {

// 1 - cos of the half angle that the sphere subtends; nothing from inside.
std::optional<float> cone_height(const BoundingSphere& sphere, Vec3f from) {
  const Vec3f d = sphere.centre - from;
  const float sin2 = sphere.radius * sphere.radius / dot(d, d);
  if (!(sin2 < 1)) return std::nullopt;
  return sin2 / (1 + std::sqrt(1 - sin2));
}

Vec3f sample_cone(Vec3f axis, float height, float u, float v) {
  const float down = u * height;
  const float sine = std::sqrt(down * (2 - down));
  const float phi = 2 * kPi * v;
  return frame_around(axis).to_world({sine * std::cos(phi), sine * std::sin(phi), 1 - down});
}

// Pdf per solid angle; `was_chosen`: the direction was sampled in this cone, so rounding at its rim cannot
// exclude it.
float density(const BoundingSphere& caster, Vec3f from, Vec3f normal, Vec3f direction, bool was_chosen) {
  const auto height = cone_height(caster, from);
  if (!height) return std::max(0.0F, dot(normal, direction)) * kInvPi;
  const Vec3f off_axis = direction - normalised(caster.centre - from);
  const float down = dot(off_axis, off_axis) / 2;  // 1 - cos, without its cancellation
  return was_chosen || down <= *height ? 1 / (2 * kPi * *height) : 0;
}

}  // namespace

CasterDirection sample_towards_casters(
    const std::vector<BoundingSphere>& casters, Vec3f from, Vec3f normal, float pick, float u, float v) {
  const auto count = casters.size();
  const auto chosen = std::min(static_cast<std::size_t>(pick * static_cast<float>(count)), count - 1);
  const auto height = cone_height(casters[chosen], from);
  const Vec3f direction = height ? sample_cone(normalised(casters[chosen].centre - from), *height, u, v)
                                 : frame_around(normal).to_world(sample_cosine(u, v));
  float sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += density(casters[i], from, normal, direction, i == chosen);
  return {direction, sum / static_cast<float>(count)};
}

}  // namespace orbs::tracer

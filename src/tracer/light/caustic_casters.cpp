#include "tracer/light/caustic_casters.h"

#include <algorithm>

namespace orbs::tracer {

CasterDirection sample_towards_casters(
    const std::vector<BoundingSphere>& casters, Vec3f from, Vec3f normal, float pick, float u, float v) {
  const auto count = casters.size();
  const auto chosen = std::min(static_cast<std::size_t>(pick * static_cast<float>(count)), count - 1);
  const Vec3f direction = direction_towards(casters[chosen], from, normal, u, v);
  float sum = 0;
  for (std::size_t i = 0; i < count; ++i)
    sum += pdf_towards(casters[i], from, normal, direction, i == chosen);
  return {direction, sum / static_cast<float>(count)};
}

}  // namespace orbs::tracer

#include "tracer/world/edge_distance.h"

#include <algorithm>
#include <array>

namespace orbs::tracer {

Vec2f away_from_edges(Vec2f barycentric, Vec3f edge1, Vec3f edge2, float position_error) {
  const std::array<float, 3> weights{1 - barycentric.x - barycentric.y, barycentric.x, barycentric.y};
  if (std::min({weights[0], weights[1], weights[2]}) >= kMostOfHeight) return {};
  // In double, in which no product of two lengths underflows.
  const auto e1 = cast<double>(edge1);
  const auto e2 = cast<double>(edge2);
  const double twice_area = length(cross(e1, e2));
  if (!(twice_area > 0)) return {};
  // A weight is the distance from the opposite edge, as a share of the height above it.
  const double distance = static_cast<double>(kEdgeDistance) * static_cast<double>(position_error);
  const std::array<double, 3> edges{length(e2 - e1), length(e2), length(e1)};
  std::array<double, 3> above{};
  double raised = 0;
  double slack = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double least = std::min(distance * edges[i] / twice_area, static_cast<double>(kMostOfHeight));
    above[i] = static_cast<double>(weights[i]) - least;
    raised += std::max(0.0, -above[i]);
    slack += std::max(0.0, above[i]);
  }
  if (raised == 0) return {};
  // Those below the least are raised to it, at the cost of the others in proportion to what they have more.
  const auto change = [&](std::size_t i) { return above[i] < 0 ? -above[i] : -above[i] * raised / slack; };
  return {static_cast<float>(change(1)), static_cast<float>(change(2))};
}

}  // namespace orbs::tracer

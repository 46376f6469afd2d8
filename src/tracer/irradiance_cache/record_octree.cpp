#include "tracer/irradiance_cache/record_octree.h"

#include <cmath>

namespace orbs::tracer {

namespace {

// Halving a float's mantissa away: deeper cubes could not be told apart.
constexpr int kDeepest = 24;

}  // namespace

RecordOctree::RecordOctree(Vec3f low, Vec3f high)
    : root_{(low + high) * 0.5F, largest_magnitude(high - low) / 2}, nodes_(1) {}

void RecordOctree::insert(std::uint32_t record, Vec3f centre, float radius) {
  insert(0, root_, record, {centre, radius}, 0);
}

void RecordOctree::insert(
    std::uint32_t node, const Cube& cube, std::uint32_t record, const Ball& ball, int depth) {
  // Children would be smaller than the record's own cube.
  if (cube.half_side < 2 * ball.radius || depth == kDeepest) {
    nodes_[node].records.push_back(record);
    return;
  }
  for (std::size_t octant = 0; octant < 8; ++octant) {
    const Cube child = child_of(cube, octant);
    if (largest_magnitude(ball.centre - child.centre) > child.half_side + ball.radius) continue;
    if (nodes_[node].children[octant] == 0) {
      nodes_[node].children[octant] = static_cast<std::uint32_t>(nodes_.size());
      nodes_.emplace_back();
    }
    insert(nodes_[node].children[octant], child, record, ball, depth + 1);
  }
}

}  // namespace orbs::tracer

#include "tracer/irradiance_cache/irradiance_cache.h"

#include <algorithm>
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

namespace {

InterpolatedIrradiance not_negative(Vec3f value) {
  const Vec3f clamped{std::max(0.0F, value.x), std::max(0.0F, value.y), std::max(0.0F, value.z)};
  return {clamped, !(clamped == value)};
}

}  // namespace

IrradianceCache::IrradianceCache(const scene::IrradianceCache& settings, Vec3f low, Vec3f high)
    : settings_(settings), octree_(low, high) {}

std::optional<InterpolatedIrradiance> IrradianceCache::lookup(const SurfaceElement& at) const {
  Vec3f sum;
  float weights = 0;
  std::optional<Vec3f> at_record;  // a relative error of zero has no finite weight: it decides alone
  octree_.for_each_at(at.position, [&](std::uint32_t index) {
    const IrradianceRecord& record = records_[index];
    const float error = relative_error(settings_, record, at);
    if (!(error < 1) || is_behind(record, at)) return;
    const Vec3f value = extrapolated(record, at);
    if (error == 0) {
      if (!at_record) at_record = value;
      return;
    }
    const float weight = record_weight(settings_, error);
    sum += value * weight;
    weights += weight;
  });
  if (at_record) return not_negative(*at_record);
  // The weight of an error that rounds to 1 is zero: such records do not count.
  if (!(weights > 0)) return std::nullopt;
  return not_negative(sum / weights);
}

bool IrradianceCache::covers(const SurfaceElement& at) const {
  bool is_covered = false;
  octree_.for_each_at(at.position, [&](std::uint32_t index) {
    if (is_covered) return;
    is_covered = relative_error(settings_, records_[index], at) < 1 && !is_behind(records_[index], at);
  });
  return is_covered;
}

// Over all records: which of them are near depends on their distances, which shrink as others come in. 10 000
// records need 5e7 differences in all; each record needs hundreds of paths.
void IrradianceCache::clamp_to_neighbours(IrradianceRecord& record) {
  const auto between = [&](const IrradianceRecord& other) {
    return length(other.at.position - record.at.position);
  };
  for (const IrradianceRecord& other : records_)
    record.distance = std::min(record.distance, other.distance + between(other));
  for (IrradianceRecord& other : records_)
    other.distance = std::min(other.distance, record.distance + between(other));
}

void IrradianceCache::insert(IrradianceRecord record) {
  if (settings_.has_gradients) limit_by_gradient(settings_, record);
  if (settings_.clamps_to_neighbours) clamp_to_neighbours(record);
  octree_.insert(static_cast<std::uint32_t>(records_.size()), record.at.position, reach(settings_, record));
  records_.push_back(record);
}

}  // namespace orbs::tracer

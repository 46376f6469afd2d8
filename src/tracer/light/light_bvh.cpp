#include "tracer/light/light_bvh.h"

#include <algorithm>
#include <array>

namespace orbs::tracer {

namespace {

constexpr double kBelowOne = 0x1.fffffffffffffp-1;  // quotients may round to one

float along(Vec3f v, std::size_t axis) { return std::array{v.x, v.y, v.z}[axis]; }

template <typename Leaves>
std::size_t longest_axis(const Leaves& leaves, std::size_t begin, std::size_t end) {
  std::size_t longest = 0;
  float length = -1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    float low = along(centre_of(leaves[begin].first), axis);
    float high = low;
    for (std::size_t i = begin + 1; i < end; ++i) {
      const float at = along(centre_of(leaves[i].first), axis);
      low = std::min(low, at);
      high = std::max(high, at);
    }
    if (!(high - low > length)) continue;
    length = high - low;
    longest = axis;
  }
  return longest;
}

// Tighter than what pairwise merging leaves: of a tessellated ball about its radius.
float radius_about(Vec3f centre, const std::vector<LightBounds>& emitters, const EmitterGroup& group) {
  float radius = 0;
  for (std::size_t i = group.first; i < group.first + group.count; ++i)
    radius = std::max(radius, length(centre_of(emitters[i]) - centre) + emitters[i].radius);
  return radius;
}

}  // namespace

LightBvh::LightBvh(const std::vector<LightBounds>& emitters, const std::vector<EmitterGroup>& groups) {
  std::vector<Leaf> leaves;
  power_up_to_.resize(emitters.size());
  for (const EmitterGroup& group : groups) {
    LightBounds bounds = emitters[group.first];
    power_up_to_[group.first] = bounds.power;
    for (std::size_t i = group.first + 1; i < group.first + group.count; ++i) {
      bounds = merged(bounds, emitters[i]);
      power_up_to_[i] = power_up_to_[i - 1] + emitters[i].power;
    }
    bounds.power = power_up_to_[group.first + group.count - 1];
    bounds.radius = radius_about(centre_of(bounds), emitters, group);
    if (bounds.power > 0) leaves.emplace_back(bounds, group);
  }
  if (leaves.size() < 2) return;
  nodes_.reserve(2 * leaves.size() - 1);
  leaf_of_.assign(emitters.size(), 0);
  build(leaves, 0, leaves.size(), 0);
  number_factors();
}

// Halves of equal count keep the tree balanced: its depth bounds both the time of a selection and how finely
// u is divided. Equal centres are ordered by number, so that the tree does not depend on the sort.
std::uint32_t LightBvh::build(std::vector<Leaf>& leaves,
                              std::size_t begin,
                              std::size_t end,
                              std::uint32_t parent) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({.bounds = {}, .parent = parent, .group = {}});
  if (end - begin == 1) {
    const auto& [bounds, group] = leaves[begin];
    nodes_[index].bounds = bounds;
    nodes_[index].group = group;
    std::fill_n(leaf_of_.begin() + static_cast<std::ptrdiff_t>(group.first), group.count, index);
    return index;
  }
  const std::size_t axis = longest_axis(leaves, begin, end);
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::size_t i) { return leaves.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end), [&](const Leaf& a, const Leaf& b) {
    const float first = along(centre_of(a.first), axis);
    const float second = along(centre_of(b.first), axis);
    return first != second ? first < second : a.second.first < b.second.first;
  });
  const std::uint32_t left = build(leaves, begin, middle, index);
  const std::uint32_t right = build(leaves, middle, end, index);
  nodes_[index].left = left;
  nodes_[index].right = right;
  nodes_[index].bounds = merged(nodes_[left].bounds, nodes_[right].bounds);
  return index;
}

// Breadth first, so that the upper nodes have numbers.
void LightBvh::number_factors() {
  constexpr std::size_t kMost = 255;  // a tree of 128 leaves, without its root
  std::vector<std::uint32_t> level{0};
  while (!level.empty() && factor_count_ + 2 * level.size() <= kMost) {
    std::vector<std::uint32_t> next;
    for (const std::uint32_t index : level)
      if (nodes_[index].right != 0)
        for (const std::uint32_t child : {nodes_[index].left, nodes_[index].right}) {
          nodes_[child].factor = static_cast<std::uint32_t>(factor_count_++);
          next.push_back(child);
        }
    level = std::move(next);
  }
}

void LightBvh::learn(const std::vector<LightTrial>& selected, const RegionGrid& grid) {
  factors_ = {};
  LightSums sums(grid, factor_count_);
  for (const LightTrial& trial : selected) {
    std::uint32_t index = leaf_of_[trial.emitter];
    const EmitterGroup& group = nodes_[index].group;
    // What the sample is worth to the node: over the probability with which the node selects the emitter.
    float worth =
        trial.irradiance *
        (group.count == 1 ? 1 : power_up_to_[group.first + group.count - 1] / power_of(trial.emitter));
    const std::size_t row = sums.row_for(trial.at);
    for (; index != 0; index = nodes_[index].parent) {
      const float promised = importance(nodes_[index].bounds, trial.at);
      if (!(promised > 0)) break;  // by rounding
      if (nodes_[index].factor > 0) sums.add(row, nodes_[index].factor, worth / promised);
      const Node& parent = nodes_[nodes_[index].parent];
      const float left = share_of_left(parent, trial.at, nullptr);
      worth /= parent.left == index ? left : 1 - left;
    }
  }
  factors_ = sums.factors();
}

float LightBvh::share_of_left(const Node& node, const LightSampleContext& at, const float* factors) const {
  float left = importance(nodes_[node.left].bounds, at);
  float right = importance(nodes_[node.right].bounds, at);
  // Both children have a factor or none has.
  if (factors != nullptr && nodes_[node.left].factor > 0) {
    left *= factors[nodes_[node.left].factor];
    right *= factors[nodes_[node.right].factor];
  }
  return left > 0 || right > 0 ? left / (left + right) : -1;
}

SelectedEmitter LightBvh::select_within(const EmitterGroup& group, double u) const {
  const auto begin = power_up_to_.begin() + static_cast<std::ptrdiff_t>(group.first);
  const auto end = begin + static_cast<std::ptrdiff_t>(group.count);
  const float total = *(end - 1);
  const auto found = std::min(std::upper_bound(begin, end, u * static_cast<double>(total)), end - 1);
  const auto emitter = static_cast<std::size_t>(found - power_up_to_.begin());
  return {emitter, group.count == 1 ? 1 : power_of(emitter) / total};
}

float LightBvh::power_of(std::size_t emitter) const {
  const std::size_t first = nodes_[leaf_of_[emitter]].group.first;
  return power_up_to_[emitter] - (emitter > first ? power_up_to_[emitter - 1] : 0);
}

std::optional<SelectedEmitter> LightBvh::select(const LightSampleContext& at, double u) const {
  const float* const factors = factors_at(at);
  std::uint32_t index = 0;
  float probability = 1;
  while (nodes_[index].right != 0) {
    const float left = share_of_left(nodes_[index], at, factors);
    if (left < 0) return std::nullopt;
    const double share = left;
    if (u < share) {
      probability *= left;
      u = std::min(u / share, kBelowOne);
      index = nodes_[index].left;
    } else {
      probability *= 1 - left;
      u = std::min((u - share) / (1 - share), kBelowOne);
      index = nodes_[index].right;
    }
  }
  auto selected = select_within(nodes_[index].group, u);
  selected.probability *= probability;
  return selected;
}

float LightBvh::probability(const LightSampleContext& at, std::size_t emitter) const {
  std::uint32_t index = leaf_of_[emitter];
  if (index == 0) return 0;
  const float* const factors = factors_at(at);
  const EmitterGroup& group = nodes_[index].group;
  float probability = group.count == 1 ? 1 : power_of(emitter) / power_up_to_[group.first + group.count - 1];
  while (index != 0) {
    const Node& parent = nodes_[nodes_[index].parent];
    const float left = share_of_left(parent, at, factors);
    if (left < 0) return 0;
    probability *= parent.left == index ? left : 1 - left;
    index = nodes_[index].parent;
  }
  return probability;
}

}  // namespace orbs::tracer

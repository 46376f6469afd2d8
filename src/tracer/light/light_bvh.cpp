#include "tracer/light/light_bvh.h"

#include <algorithm>
#include <array>

namespace orbs::tracer {

namespace {

constexpr float kBelowOne = 0x1.fffffep-1F;  // quotients may round to one

float along(Vec3f v, std::size_t axis) { return std::array{v.x, v.y, v.z}[axis]; }

Vec3f centre_of(const LightBounds& bounds) { return (bounds.low + bounds.high) * 0.5F; }

std::size_t longest_axis(const std::vector<LightBounds>& emitters,
                         const std::vector<std::uint32_t>& order,
                         std::size_t begin,
                         std::size_t end) {
  std::size_t longest = 0;
  float length = -1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    float low = along(centre_of(emitters[order[begin]]), axis);
    float high = low;
    for (std::size_t i = begin + 1; i < end; ++i) {
      const float at = along(centre_of(emitters[order[i]]), axis);
      low = std::min(low, at);
      high = std::max(high, at);
    }
    if (!(high - low > length)) continue;
    length = high - low;
    longest = axis;
  }
  return longest;
}

}  // namespace

LightBvh::LightBvh(const std::vector<LightBounds>& emitters) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < emitters.size(); ++i)
    if (emitters[i].power > 0) order.push_back(i);
  if (order.size() < 2) return;
  nodes_.reserve(2 * order.size() - 1);
  leaf_of_.assign(emitters.size(), 0);
  build(emitters, order, 0, order.size(), 0);
}

// Halves of equal count keep the tree balanced: its depth bounds both the time of a selection and how finely
// u is divided. Equal centres are ordered by index, so that the tree does not depend on the sort.
std::uint32_t LightBvh::build(const std::vector<LightBounds>& emitters,
                              std::vector<std::uint32_t>& order,
                              std::size_t begin,
                              std::size_t end,
                              std::uint32_t parent) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({.bounds = {}, .parent = parent});
  if (end - begin == 1) {
    nodes_[index].bounds = emitters[order[begin]];
    nodes_[index].emitter = order[begin];
    leaf_of_[order[begin]] = index;
    return index;
  }
  const std::size_t axis = longest_axis(emitters, order, begin, end);
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::size_t i) { return order.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end), [&](std::uint32_t a, std::uint32_t b) {
    const float first = along(centre_of(emitters[a]), axis);
    const float second = along(centre_of(emitters[b]), axis);
    return first != second ? first < second : a < b;
  });
  const std::uint32_t left = build(emitters, order, begin, middle, index);
  const std::uint32_t right = build(emitters, order, middle, end, index);
  nodes_[index].left = left;
  nodes_[index].right = right;
  nodes_[index].bounds = merged(nodes_[left].bounds, nodes_[right].bounds);
  return index;
}

float LightBvh::share_of_left(const Node& node, const LightSampleContext& at) const {
  const float left = importance(nodes_[node.left].bounds, at);
  const float right = importance(nodes_[node.right].bounds, at);
  return left > 0 || right > 0 ? left / (left + right) : -1;
}

std::optional<SelectedEmitter> LightBvh::select(const LightSampleContext& at, float u) const {
  std::uint32_t index = 0;
  float probability = 1;
  while (nodes_[index].right != 0) {
    const float left = share_of_left(nodes_[index], at);
    if (left < 0) return std::nullopt;
    if (u < left) {
      probability *= left;
      u = std::min(u / left, kBelowOne);
      index = nodes_[index].left;
    } else {
      probability *= 1 - left;
      u = std::min((u - left) / (1 - left), kBelowOne);
      index = nodes_[index].right;
    }
  }
  return SelectedEmitter{nodes_[index].emitter, probability};
}

float LightBvh::probability(const LightSampleContext& at, std::size_t emitter) const {
  std::uint32_t index = leaf_of_[emitter];
  if (index == 0) return 0;
  float probability = 1;
  while (index != 0) {
    const Node& parent = nodes_[nodes_[index].parent];
    const float left = share_of_left(parent, at);
    if (left < 0) return 0;
    probability *= parent.left == index ? left : 1 - left;
    index = nodes_[index].parent;
  }
  return probability;
}

}  // namespace orbs::tracer

#pragma once

#include "tracer/light/light_bounds.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace orbs::tracer {

/// An emitter and the probability with which it was selected.
struct SelectedEmitter {
  std::size_t emitter = 0;
  float probability = 0;
};

/// Selects emitters by what they may contribute to a point: from the root down, each child with a probability
/// in proportion to its importance (Conty Estevez and Kulla 2018).
class LightBvh {
 public:
  LightBvh() = default;
  /// Bounds of each emitter; those without power are never selected. The tree is empty below two emitters,
  /// between which nothing is to be chosen.
  explicit LightBvh(const std::vector<LightBounds>& emitters);

  bool empty() const { return nodes_.empty(); }
  /// For u in [0, 1). Nothing if no emitter can shine on the point.
  std::optional<SelectedEmitter> select(const LightSampleContext& at, float u) const;
  /// With which select() chooses this emitter for the point.
  float probability(const LightSampleContext& at, std::size_t emitter) const;

 private:
  struct Node {
    LightBounds bounds;
    std::uint32_t parent = 0;  // of the root: itself
    std::uint32_t left = 0;    // the right child follows the left subtree
    std::uint32_t right = 0;   // 0: a leaf
    std::uint32_t emitter = 0;
  };

  std::uint32_t build(const std::vector<LightBounds>& emitters,
                      std::vector<std::uint32_t>& order,
                      std::size_t begin,
                      std::size_t end,
                      std::uint32_t parent);
  float share_of_left(const Node& node, const LightSampleContext& at) const;

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> leaf_of_;  // per emitter; 0: it has none, as the root is no leaf
};

}  // namespace orbs::tracer

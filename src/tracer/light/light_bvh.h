#pragma once

#include "tracer/light/light_bounds.h"
#include "tracer/light/light_factors.h"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace orbs::tracer {

/// An emitter and the probability with which it was selected.
struct SelectedEmitter {
  std::size_t emitter = 0;
  float probability = 0;
};

/// A trial light sample: what it found for this point, of the emitter alone. Zero if something is in between
/// or the emitter does not shine on the point.
struct LightTrial {
  LightSampleContext at;
  std::size_t emitter = 0;
  float irradiance = 0;  // in the unit of LightBounds::power per m^2
};

/// Emitters with consecutive numbers that the tree does not tell apart: an area light alone, or the triangles
/// of one object. A closed mesh hides most of its triangles from any point, and near ones behind would be
/// taken for more than they are; a tree of triangles made scene 124 of ORB.S noisier than none.
struct EmitterGroup {
  std::size_t first = 0;
  std::size_t count = 1;
};

/// Selects emitters by what they may contribute to a point: from the root down to a group, each child with a
/// probability in proportion to its importance (Conty Estevez and Kulla 2018), and within the group by power.
class LightBvh {
 public:
  LightBvh() = default;
  /// Bounds of each emitter; those without power are never selected. The tree is empty below two groups with
  /// power, between which nothing is to be chosen.
  LightBvh(const std::vector<LightBounds>& emitters, const std::vector<EmitterGroup>& groups);

  bool empty() const { return nodes_.empty(); }
  /// For u in [0, 1), of which each step down takes as many bits as its child is improbable. Nothing if no
  /// emitter can shine on the point.
  std::optional<SelectedEmitter> select(const LightSampleContext& at, double u) const;
  /// With which select() chooses this emitter for the point.
  float probability(const LightSampleContext& at, std::size_t emitter) const;

  /// From now on multiplies the importances of the upper nodes by factors that trials gave for the region of
  /// the point (light_factors.h); `selected` by this tree before it had learned anything.
  void learn(const std::vector<LightTrial>& selected, const RegionGrid& grid);
  bool has_learned() const { return !factors_.empty(); }
  const LightFactors& factors() const { return factors_; }

 private:
  struct Node {
    LightBounds bounds;
    std::uint32_t parent = 0;  // of the root: itself
    std::uint32_t left = 0;    // the right child follows the left subtree
    std::uint32_t right = 0;   // 0: a leaf
    EmitterGroup group;        // of a leaf
    std::uint32_t factor = 0;  // its number in the rows of factors_; 0: none, it is too deep in the tree
  };
  using Leaf = std::pair<LightBounds, EmitterGroup>;

  std::uint32_t build(std::vector<Leaf>& leaves, std::size_t begin, std::size_t end, std::uint32_t parent);
  void number_factors();
  float share_of_left(const Node& node, const LightSampleContext& at, const float* factors) const;
  const float* factors_at(const LightSampleContext& at) const {
    return factors_.empty() ? nullptr : factors_.row_at(at);
  }
  SelectedEmitter select_within(const EmitterGroup& group, double u) const;
  float power_of(std::size_t emitter) const;

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> leaf_of_;  // per emitter; 0: it has none, as the root is no leaf
  std::vector<float> power_up_to_;      // per emitter: of those of its group up to and with itself
  std::size_t factor_count_ = 1;
  LightFactors factors_;  // empty: nothing was learned
};

}  // namespace orbs::tracer

#pragma once

#include "tracer/light/emitter.h"

#include <cstdint>
#include <vector>

namespace orbs::tracer {

/// All emitters: area lights first, then emissive triangles. Each is selected with probability proportional
/// to its power.
class EmitterTable {
 public:
  /// One power per emitter; `triangles` are the emitters behind the first `light_count`.
  void build(const std::vector<float>& powers,
             std::vector<TriangleEmitter> triangles,
             std::size_t light_count);
  bool empty() const { return probability_.empty(); }
  std::size_t size() const { return probability_.size(); }
  std::size_t light_count() const { return light_count_; }
  /// Index of an emitter for u in [0, 1), by the alias method (Walker 1977, Vose 1991). u needs more digits
  /// than a float has: with 24 bits a lamp of a billionth of the power would be picked 60 times too often.
  std::size_t pick(double u) const;
  /// Selection probability; zero if no emitter has power, as with spectra outside the visible range.
  float probability(std::size_t emitter) const { return probability_.empty() ? 0 : probability_[emitter]; }
  const TriangleEmitter& triangle(std::size_t emitter) const { return triangles_[emitter - light_count_]; }

 private:
  std::size_t light_count_ = 0;
  std::vector<TriangleEmitter> triangles_;
  std::vector<float> probability_;
  std::vector<double> keep_;
  std::vector<std::uint32_t> alias_;
};

}  // namespace orbs::tracer

#pragma once

#include "tracer/light/emitter.h"
#include "tracer/plugins/plugin_emitter.h"

#include <cstdint>
#include <vector>

namespace orbs::tracer {

/// What of the table is no light, in the order of its indices behind these.
struct SurfaceEmitters {
  std::vector<TriangleEmitter> triangles;
  std::vector<PluginEmitter> plugin_shapes;
};

/// All emitters: lights first, then emissive triangles, then glowing shapes of plug-ins. Each is
/// selected with probability proportional to its power.
class EmitterTable {
 public:
  /// One power per emitter; `surfaces` are the emitters behind the first `light_count`.
  void build(const std::vector<float>& powers, SurfaceEmitters surfaces, std::size_t light_count);
  bool empty() const { return probability_.empty(); }
  std::size_t size() const { return probability_.size(); }
  std::size_t light_count() const { return light_count_; }
  /// Index of an emitter for u in [0, 1), by the alias method (Walker 1977, Vose 1991). u needs more digits
  /// than a float has: with 24 bits a lamp of a billionth of the power would be picked 60 times too often.
  std::size_t pick(double u) const;
  /// Selection probability; zero if no emitter has power, as with spectra outside the visible range.
  float probability(std::size_t emitter) const { return probability_.empty() ? 0 : probability_[emitter]; }
  const TriangleEmitter& triangle(std::size_t emitter) const {
    return surfaces_.triangles[emitter - light_count_];
  }
  /// The glowing shape of a plug-in; nullptr if the emitter is another.
  const PluginEmitter* plugin_shape(std::size_t emitter) const {
    const std::size_t first = light_count_ + surfaces_.triangles.size();
    return emitter < first ? nullptr : &surfaces_.plugin_shapes[emitter - first];
  }

 private:
  std::size_t light_count_ = 0;
  SurfaceEmitters surfaces_;
  std::vector<float> probability_;
  std::vector<double> keep_;
  std::vector<std::uint32_t> alias_;
};

}  // namespace orbs::tracer

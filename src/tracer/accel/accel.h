#pragma once

#include "tracer/geometry/ray.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace orbs::tracer {

struct World;

/// Embree behind two calls. Rays go through in packets of 16: on small scenes packets cost two thirds of
/// single rays, and the traversal itself falls back to single rays where a packet falls apart. Robust mode:
/// no leaks between triangles.
class Accel {
 public:
  /// Builds over the parts of the world, whose arrays must outlive this and must not move.
  explicit Accel(const World& world);
  ~Accel();
  Accel(const Accel&) = delete;
  Accel& operator=(const Accel&) = delete;
  Accel(Accel&&) = delete;
  Accel& operator=(Accel&&) = delete;

  /// The nearest hit of each ray, part = kNoHit where there is none.
  void intersect(std::span<const Ray> rays, std::span<Hit> hits) const;
  /// 1 where something lies within the ray's reach.
  void occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace orbs::tracer

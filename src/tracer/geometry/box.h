#pragma once

#include "base/vec.h"

#include <algorithm>
#include <cmath>

namespace orbs::tracer {

/// The smallest box along the axes that holds some points.
class Box {
 public:
  void add(Vec3f p) {
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y), std::min(low_.z, p.z)};
    high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y), std::max(high_.z, p.z)};
  }
  bool empty() const { return low_.x > high_.x; }
  Vec3f centre() const { return (low_ + high_) * 0.5F; }
  Vec3f size() const { return high_ - low_; }

 private:
  Vec3f low_{INFINITY, INFINITY, INFINITY};
  Vec3f high_{-INFINITY, -INFINITY, -INFINITY};
};

}  // namespace orbs::tracer

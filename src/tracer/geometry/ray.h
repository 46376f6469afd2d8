#pragma once

#include "base/vec.h"

#include <cstdint>
#include <limits>

namespace orbs::tracer {

struct Ray {
  Vec3f origin;
  Vec3f direction;  // unit for camera and scattered rays; target - origin for shadow rays
  float reach = std::numeric_limits<float>::infinity();  // in units of direction
  float nearest = 0;                                     // least distance of a hit, likewise
  float time = 0;                                        // within the frame; all rays of a path have the same
};

/// Hit::object of rays that hit nothing.
constexpr std::uint32_t kNoHit = 0xffffffffU;

struct Hit {
  float distance = 0;
  Vec2f barycentric;
  std::uint32_t object = kNoHit;  // index into World::objects
  std::uint32_t primitive = 0;    // triangle of its mesh
};

}  // namespace orbs::tracer

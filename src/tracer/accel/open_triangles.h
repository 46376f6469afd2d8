#pragma once

#include "tracer/accel/openings.h"
#include "tracer/accel/user_geometry.h"

#include <optional>
#include <utility>
#include <vector>

namespace orbs::tracer {

/// A triangle with a test of its own that may let rays pass.
template <typename Triangle>
struct OpenTriangle {
  Triangle triangle;
  const Openings* openings = nullptr;
  std::uint32_t object = 0;
};

template <typename Triangle>
std::vector<OpenTriangle<Triangle>> open_triangles(std::vector<Triangle> triangles,
                                                   const Openings& openings,
                                                   std::uint32_t object) {
  std::vector<OpenTriangle<Triangle>> out;
  for (Triangle& triangle : triangles) out.push_back({std::move(triangle), &openings, object});
  return out;
}

template <typename Triangle>
UserBounds bounds_of(const OpenTriangle<Triangle>& open) {
  return bounds_of(open.triangle);
}

template <typename Triangle>
std::optional<Hit> hit_of(const OpenTriangle<Triangle>& open, unsigned int index, const UserRay& ray) {
  auto hit = hit_of(open.triangle, index, ray);
  if (!hit) return hit;
  Hit placed = *hit;
  placed.object = open.object;
  if (passes(*open.openings, ray.origin, ray.direction, placed)) return std::nullopt;
  return hit;
}

}  // namespace orbs::tracer

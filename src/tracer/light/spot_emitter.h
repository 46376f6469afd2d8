#pragma once

#include "scene/lights/spot.h"
#include "tracer/light/emitter_without_area.h"

namespace orbs::tracer {

struct SpotEmitter {
  static constexpr bool kHasArea = false;
  Vec3f position;
  Vec3d axis;  // unit; in double, as a narrow spot's share changes much with its cosine
  double cos_inner = 1;
  double cos_outer = 0;
  float area = 1;  // its power is its intensity on the axis
};

SpotEmitter make_emitter(const scene::SpotShape& spot, const Mat4& matrix, Vec3d normal);
std::optional<EmitterPoint> sample_towards(const SpotEmitter& spot, Vec3f from, float u, float v);
/// The share of its intensity in this direction, which need not be a unit vector.
float share_towards(const SpotEmitter& spot, Vec3f to_viewer);
LightBounds bounds_of(const SpotEmitter& spot, float power);

}  // namespace orbs::tracer

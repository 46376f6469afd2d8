#pragma once

#include "tracer/sampling/sampler.h"
#include "tracer/world/world.h"

namespace orbs::tracer {

/// The time at which a path sees the scene, uniform while the shutter is open. The sum is in double, because
/// in float it could round past the end of the frame.
inline float time_of_path(const scene::Shutter& shutter, SampleBlock block, std::uint32_t index) {
  const double u = draw(block, index, 0, SampleDimension::Time)[0];
  return static_cast<float>(shutter.open + u * (shutter.close - shutter.open));
}

/// The camera as it is at this time.
inline PinholeCamera camera_at(const World& world, float time) {
  return world.moving_camera ? camera_at(*world.moving_camera, world.camera, time) : world.camera;
}

/// The ray of a camera sample through film position (x, y), at the time of its path.
inline Ray timed_camera_ray(const World& world, float x, float y, SampleBlock block, std::uint32_t index) {
  if (!world.shutter) return camera_ray(world.camera, x, y);
  const float time = time_of_path(*world.shutter, block, index);
  Ray ray = world.moving_camera ? camera_ray(camera_at(world, time), x, y) : camera_ray(world.camera, x, y);
  ray.time = time;
  return ray;
}

}  // namespace orbs::tracer

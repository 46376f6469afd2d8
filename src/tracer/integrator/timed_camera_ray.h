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
inline Camera camera_at(const World& world, float time) {
  return world.moving_camera ? camera_at(*world.moving_camera, world.camera, time) : world.camera;
}

/// The ray of a camera sample through film position (x, y), from its point of the lens where there is one.
inline Ray sampled_camera_ray(
    const Camera& camera, float x, float y, SampleBlock block, std::uint32_t index) {
  if (!has_lens(camera)) return camera_ray(camera, x, y);
  const auto u = draw(block, index, 0, SampleDimension::Lens);
  return camera_ray(seen_through(camera, u[0], u[1]), x, y);
}

/// The same at the time of its path.
inline Ray timed_camera_ray(const World& world, float x, float y, SampleBlock block, std::uint32_t index) {
  if (!world.shutter) return sampled_camera_ray(world.camera, x, y, block, index);
  const float time = time_of_path(*world.shutter, block, index);
  Ray ray = world.moving_camera ? sampled_camera_ray(camera_at(world, time), x, y, block, index)
                                : sampled_camera_ray(world.camera, x, y, block, index);
  ray.time = time;
  return ray;
}

}  // namespace orbs::tracer

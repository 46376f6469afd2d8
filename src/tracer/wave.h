#pragma once

#include "tracer/path_class.h"
#include "tracer/ray.h"
#include "tracer/sampler.h"
#include "tracer/transport.h"

#include <chrono>
#include <cstdint>
#include <vector>

/// What the path tracer keeps of its paths.
namespace orbs::tracer {

/// One camera sample.
struct Sample {
  int x = 0;
  int y = 0;
  SampleBlock block;
  std::uint32_t index = 0;  // within the block
};

/// Where a part of a sample's radiance came from, for --split-paths.
struct ClassedLight {
  std::uint32_t sample = 0;
  int path_class = 0;
  Vec3f radiance;
};

template <Transport T>
struct PathState {
  typename T::Weight weight{};
  typename T::Light light{};
  [[no_unique_address]] typename T::Lambda lambda{};
  Ray ray;
  std::uint32_t sample = 0;
  float scatter_pdf = 0;  // of ray.direction; 0 where light sampling could not have found what the ray meets
  float radiance_scale = 1;  // see BsdfSample
  int scatterings = 0;
  bool began_at_flat_mirror = false;    // one that has the camera before it
  bool is_met_by_light_paths = false;   // at the first surface, see is_left_to_light_paths
  bool met_sharp_beyond_first = false;  // the last surface is sharp, and not the first
  /// Of the last scattering at a flat mirror, where the one before was not specular: the image of the point
  /// where that happened, and the chance with which it asks this mirror for light. scatter_pdf is then of
  /// that point.
  bool came_by_mirror = false;
  float mirror_chance = 0;
  Vec3f mirror_image;
  PathClass events;
  Vec2f first_light;  // the half of the first set of numbers that the pixel position leaves
};

/// Whether it is about to scatter where the camera looks, by itself or by a flat mirror.
template <Transport T>
bool is_at_first_surface(const PathState<T>& path) {
  return path.scatterings == 0 || (path.scatterings == 1 && path.began_at_flat_mirror);
}

template <Transport T>
struct ShadowQuery {
  typename T::Light light{};  // arrives when nothing is in between
  std::uint32_t path = 0;
  int path_class = 0;
};

/// Light on its way by a flat mirror, see mirrored_light.h.
template <Transport T>
struct MirrorQuery {
  typename T::Weight weight{};  // up to the mirror
  typename T::Value emitted{};
  Vec3f target;  // on the light
  int plane = 0;
  std::uint32_t path = 0;
  int path_class = 0;
};

/// Scratch memory of a wave, reused from wave to wave.
template <Transport T>
struct Wave {
  std::vector<PathState<T>> paths;
  std::vector<std::uint32_t> active;
  std::vector<std::uint32_t> survivors;  // of the present scattering
  std::vector<Ray> rays;
  std::vector<Hit> hits;
  std::vector<Ray> mirror_rays;
  std::vector<Hit> mirror_hits;
  std::vector<MirrorQuery<T>> mirror_queries;
  std::vector<Ray> shadow_rays;
  std::vector<ShadowQuery<T>> shadows;
  std::vector<std::uint8_t> blocked;
  std::vector<ClassedLight> classed;  // filled when split_paths
  bool split_paths = false;
  double traversal_seconds = 0;  // spent inside the accelerator, all waves together
};

template <Transport T>
void add_light(Wave<T>& wave, PathState<T>& path, const typename T::Light& light, int path_class) {
  path.light = T::add(path.light, light);
  if (wave.split_paths) wave.classed.push_back({path.sample, path_class, T::to_rgb(light, path.lambda)});
}

/// Runs a traversal and adds its time: twice per wave and bounce, for hundreds of rays at a time, so that the
/// clock costs nothing.
template <typename W, typename F>
void timed_traversal(W& wave, const F& traverse) {
  const auto start = std::chrono::steady_clock::now();
  traverse();
  wave.traversal_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace orbs::tracer

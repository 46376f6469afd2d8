#pragma once

#include "tracer/integrator/path_class.h"
#include "tracer/geometry/ray.h"
#include "tracer/sampling/sampler.h"
#include "tracer/transport/transport.h"

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
struct ClassedRadiance {
  std::uint32_t sample = 0;
  int path_class = 0;
  Vec3f radiance;
};

template <Transport T>
struct PathState {
  typename T::Throughput throughput{};
  typename T::Contribution radiance{};
  [[no_unique_address]] typename T::Lambda lambda{};
  Ray ray;
  std::uint32_t sample = 0;
  float bsdf_pdf = 0;  // of ray.direction; 0 where light sampling could not have found what the ray meets
  float radiance_scale = 1;  // see BsdfSample
  int scatterings = 0;
  bool began_at_flat_mirror = false;    // one that has the camera before it
  bool is_reached_by_light_paths = false;   // at the first surface, see is_left_to_light_paths
  bool near_specular_beyond_first = false;  // the last surface is sharp, and not the first
  /// Of the last scattering at a flat mirror, where the one before was not specular: the image of the point
  /// where that happened, and the chance with which it asks this mirror for light. bsdf_pdf is then of
  /// that point.
  bool came_by_mirror = false;
  float mirror_probability = 0;
  Vec3f mirrored_vertex;
  PathClass events;
  Vec2f first_light_sample;  // the half of the first set of numbers that the pixel position leaves
};

/// Whether it is about to scatter where the camera looks, by itself or by a flat mirror.
template <Transport T>
bool is_at_first_surface(const PathState<T>& path) {
  return path.scatterings == 0 || (path.scatterings == 1 && path.began_at_flat_mirror);
}

template <Transport T>
struct ShadowRay {
  typename T::Contribution light{};  // arrives when nothing is in between
  std::uint32_t path = 0;
  int path_class = 0;
};

/// Light on its way by a flat mirror, see mirrored_light.h.
template <Transport T>
struct MirrorRay {
  typename T::Throughput throughput{};  // up to the mirror
  typename T::Value emitted{};
  Vec3f target;  // on the light
  int plane = 0;
  std::uint32_t path = 0;
  int path_class = 0;
};

/// Scratch memory of a batch, reused from batch to batch.
template <Transport T>
struct PathBatch {
  std::vector<PathState<T>> paths;
  std::vector<std::uint32_t> active;
  std::vector<std::uint32_t> survivors;  // of the present scattering
  std::vector<Ray> rays;
  std::vector<Hit> hits;
  std::vector<Ray> mirror_rays;
  std::vector<Hit> mirror_hits;
  std::vector<MirrorRay<T>> mirror_ray_payloads;
  std::vector<Ray> shadow_rays;
  std::vector<ShadowRay<T>> shadows;
  std::vector<std::uint8_t> blocked;
  std::vector<ClassedRadiance> classed;  // filled when split_paths
  bool split_paths = false;
  double traversal_seconds = 0;  // spent inside the accelerator, all waves together
};

template <Transport T>
void add_contribution(PathBatch<T>& batch, PathState<T>& path, const typename T::Contribution& light, int path_class) {
  path.radiance = T::add(path.radiance, light);
  if (batch.split_paths) batch.classed.push_back({path.sample, path_class, T::to_rgb(light, path.lambda)});
}

/// Runs a traversal and adds its time: twice per batch and bounce, for hundreds of rays at a time, so that the
/// clock costs nothing.
template <typename W, typename F>
void timed_traversal(W& batch, const F& traverse) {
  const auto start = std::chrono::steady_clock::now();
  traverse();
  batch.traversal_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace orbs::tracer

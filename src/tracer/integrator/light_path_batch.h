#pragma once

#include "tracer/integrator/light_emission.h"
#include "tracer/integrator/path_class.h"
#include "tracer/transport/transport.h"

#include <concepts>
#include <cstdint>
#include <vector>

/// The state of light tracing.
namespace orbs::tracer {

/// What a light path adds to a pixel. The radiance of the pixel is the sum of its splats over the number of
/// all light paths, also of those that miss it.
struct Splat {
  std::uint32_t pixel = 0;
  int path_class = 0;
  Vec3f value;
};

/// Transports whose throughputs are plain factors. Matrices would have to be multiplied in the reverse order.
template <typename T>
concept TracesFromLights = Transport<T> && std::same_as<typename T::Throughput, typename T::Value>;

template <TracesFromLights T>
struct LightPath {
  typename T::Value throughput{};  // of all scattering events, without the start
  typename T::Value emitted{};     // radiance of the emitter times start.weight, which is cosine over pdf
  [[no_unique_address]] typename T::Lambda lambda{};
  EmittedRay start;
  Ray ray;
  std::uint32_t index = 0;  // within the sample block
  int scatterings = 0;
  bool began_at_flat_mirror = false;
  PathClass events;
};

/// A connection to the camera by way of a flat mirror, before its ray has hit the mirror.
template <TracesFromLights T>
struct CameraMirrorPayload {
  typename T::Value throughput{};  // from the light up to the mirror
  Vec3f viewpoint;                 // of the camera, before the mirror
  std::uint32_t path = 0;
  std::uint32_t pixel = 0;
  int plane = 0;
  int path_class = 0;
};

/// Light paths that are traced together, and scratch memory that is reused from batch to batch.
template <TracesFromLights T>
struct LightPathBatch {
  std::vector<LightPath<T>> paths;
  std::vector<std::uint32_t> active;
  std::vector<Ray> rays;
  std::vector<Hit> hits;
  std::vector<Ray> mirror_rays;
  std::vector<Hit> mirror_hits;
  std::vector<CameraMirrorPayload<T>> mirror_payloads;  // of mirror_rays
  std::vector<Ray> camera_rays;
  std::vector<Splat> camera_payloads;  // of camera_rays; added if not blocked
  std::vector<std::uint8_t> blocked;
  std::vector<Splat> splats;  // the result
  double traversal_seconds = 0;
};

}  // namespace orbs::tracer

#pragma once

#include "tracer/accel/timed_traversal.h"
#include "tracer/geometry/lanes.h"
#include "tracer/geometry/ray.h"
#include "tracer/integrator/light_vertex.h"
#include "tracer/integrator/path_class.h"
#include "tracer/integrator/sample.h"
#include "tracer/transport/transport.h"

#include <array>
#include <cstdint>
#include <vector>

/// The state of the path tracer.
namespace orbs::tracer {

/// A contribution with its class of light path, recorded for --split-paths.
struct ClassedRadiance {
  std::uint32_t sample = 0;
  int path_class = 0;
  Vec3f radiance;
};

template <Transport T>
struct PathState {
  typename T::Throughput throughput{};
  typename T::Contribution radiance{};  // found so far
  [[no_unique_address]] typename T::Lambda lambda{};
  Ray ray;
  std::uint32_t sample = 0;
  /// Pdf of ray.direction for MIS; 0 if light sampling could not have found what the ray hits.
  float bsdf_pdf = 0;
  float radiance_scale = 1;  // product of BsdfSample::radiance_scale, the inverse of pbrt's etaScale
  int scatterings = 0;
  bool has_deltas_alone = true;       // all its scattering events so far had a delta function
  bool began_at_flat_mirror = false;  // one that has the camera in front of it
  /// The first surface is not near-specular, or the path left it in the tail of its lobe: light paths connect
  /// it to the camera.
  bool is_reached_by_light_paths = false;
  bool near_specular_beyond_first = false;  // the last surface is near-specular and is not the first
  /// The last bounce was off a flat mirror, and the vertex before it has no delta function: next-event
  /// estimation there could have sampled the same light by way of the mirror. bsdf_pdf is still that of the
  /// vertex.
  bool came_by_mirror = false;
  float mirror_probability = 0;  // with which the vertex picks this mirror
  /// The last vertex, or its mirror image where the path came by a mirror: where next-event estimation could
  /// have sampled what the ray hits. Not the origin of the ray, which is offset from it: close to an emitter
  /// the pdfs at both differ.
  LightSampleContext light_sample;
  /// Density per m^2 with which the last vertex but one sampled the last one, where it could have connected
  /// to the same point as a light vertex; else 0.
  float arrival_pdf = 0;
  /// connection_pdf of what the ray hits, over its emission_pdf.
  float connection_pdf = 0;
  PathClass events;
  Vec2f first_light_numbers;  // of the four random numbers of PixelAndFirstLight, the two for the light
};

/// True if the path is about to scatter at the surface that the camera sees or, where that is a flat mirror,
/// at the surface that the camera sees in it.
template <Transport T>
bool is_at_first_surface(const PathState<T>& path) {
  return path.scatterings == 0 || (path.scatterings == 1 && path.began_at_flat_mirror);
}

/// True if camera paths must not add the emitter that this path reaches next, because light paths add it
/// (trace_light_batch.h): the last surface is near-specular, and the first one, which the camera sees
/// directly or in a flat mirror, is not, or scattered the path in the tail of its lobe (kTailPdf).
template <Transport T>
bool is_left_to_light_paths(const World& world, const PathState<T>& path) {
  return path.near_specular_beyond_first && path.is_reached_by_light_paths && !world.caustic_casters.empty();
}

/// What a shadow ray adds to its path if it is not blocked.
template <Transport T>
struct ShadowPayload {
  typename T::Contribution light{};
  std::uint32_t path = 0;
  int path_class = 0;
};

/// A light sample by way of a flat mirror, before its ray has hit the mirror (sample_mirrored_light.h).
template <Transport T>
struct MirrorPayload {
  typename T::Throughput throughput{};  // up to the mirror
  typename T::Value emitted{};
  Vec3f target;  // on the light
  int plane = 0;
  std::uint32_t path = 0;
  int path_class = 0;
};

/// Paths that are traced together, and scratch memory that is reused from batch to batch.
template <Transport T>
struct PathBatch {
  std::vector<PathState<T>> paths;
  std::vector<std::uint32_t> active;
  std::vector<std::uint32_t> survivors;  // of the current bounce
  std::vector<Ray> rays;                 // of the active paths
  std::vector<Hit> hits;
  std::vector<Ray> mirror_rays;
  std::vector<Hit> mirror_hits;
  std::vector<MirrorPayload<T>> mirror_payloads;  // of mirror_rays
  std::vector<Ray> shadow_rays;
  std::vector<ShadowPayload<T>> shadow_payloads;  // of shadow_rays
  std::vector<std::uint8_t> blocked;
  LightVertexPool light_vertices;        // empty unless World::connects_light_vertices
  std::vector<ClassedRadiance> classed;  // filled if split_paths
  bool split_paths = false;
  double traversal_seconds = 0;  // inside the accelerator, summed over all batches
};

/// Up to eight paths at hit points where they scatter, as structure of arrays: their geometry is computed in
/// vector registers. Lanes from `count` on hold stale values. Vector code computes with them, and nothing
/// uses the results.
template <Transport T>
struct VertexLanes {
  Vec8 position{};
  Vec8 geometric_normal{};
  Vec8 shading_normal{};  // flipped to the viewer
  Vec8 to_viewer{};
  Float8 position_error{};
  SampleBlocks blocks;
  Word8 index{};  // of the sample within its block
  std::array<std::uint32_t, kLanes> path{};
  std::array<typename T::Bsdf, kLanes> bsdf;
  std::array<bool, kLanes> samples_light{};  // next-event estimation is done here
  std::array<int, kLanes> mirror_plane{};    // of the surface, or -1
  std::array<int, kLanes> own_light{};       // the light that the surface belongs to, or -1
  std::size_t count = 0;
};

template <Transport T>
void add_contribution(PathBatch<T>& batch,
                      PathState<T>& path,
                      const typename T::Contribution& light,
                      int path_class) {
  path.radiance = T::add(path.radiance, light);
  if (batch.split_paths) batch.classed.push_back({path.sample, path_class, T::to_rgb(light, path.lambda)});
}

}  // namespace orbs::tracer

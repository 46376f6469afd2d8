#pragma once

#include "tracer/integrator/light_emission.h"
#include "tracer/integrator/sample.h"
#include "tracer/world/surface.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

/// The first hits of light paths, to which camera paths connect (connect_light_vertices.h): bidirectional
/// path tracing with light subpaths of at most two vertices (Lafortune and Willems 1993; Veach 1997, ch. 10).
/// Light that enters a room by way of one small bright wall is found by it, where camera paths would have to
/// hit the wall by chance.
namespace orbs::tracer {

/// Where light straight from an emitter hits a surface that scatters it in a broad lobe.
struct LightVertex {
  SurfacePoint point;
  Hit hit;
  Vec3f to_light;  // unit
  Vec3f light_position;
  std::size_t emitter = 0;
  Radiance radiance;  // that arrives
  /// Density with which a light path starts at this point of the emitter, per m^2, times that of its
  /// direction over the density of a cosine lobe (emission_pdf).
  float emission_pdf = 0;
  float cos_light = 0;  // of to_light at the geometric normal
};

/// The light vertices of a batch. Of `traced` light paths, those are left that found a vertex.
struct LightVertexPool {
  std::vector<LightVertex> vertices;
  std::size_t traced = 0;
  std::uint32_t first = 0;  // vertex of the first camera path; random
  std::vector<Ray> rays;    // scratch memory
  std::vector<EmittedRay> emitted;
  std::vector<Hit> hits;
  double traversal_seconds = 0;  // of the last batch
};

/// Density of a vertex as a light path finds it, relative to that of a camera path's BSDF sample there:
/// p(emitter point) p(direction) / A, in which the factor that turns the emitter point's area into solid
/// angle at the vertex is cancelled against that of the other techniques. So it can stand beside the pdfs of
/// light and BSDF sampling, per solid angle at the vertex, in the weights of MIS. `arrival_pdf` is the
/// density per m^2 with which the camera path's previous vertex sampled this one; 0 if none could have been
/// connected.
inline float connection_pdf(float emission_pdf, float cos_light, float arrival_pdf) {
  return arrival_pdf > 0 ? emission_pdf * cos_light * kInvPi / arrival_pdf : 0;
}

/// Traces one light path for each camera sample of the batch and refills the pool. Their random numbers are
/// functions of those of the samples.
void trace_light_vertices(LightVertexPool& pool, const World& world, std::span<const Sample> samples);

/// What a connection of this point to the vertex would contribute if nothing stood between, up to the
/// reflectances and what is common to all vertices. A radiance that is given by its spectrum alone counts as
/// one.
float unblocked_contribution(const LightVertex& vertex, const LightSampleContext& at);

/// A vertex of the pool, and the factor that its contribution is multiplied by for the others that were not
/// selected.
struct SelectedVertex {
  const LightVertex& vertex;
  float weight = 1;
};

/// The vertex that this camera path connects to after so many bounces: of a few, each equally likely to be
/// among them, one in proportion to what it would contribute if nothing stood between (resampled importance
/// sampling; Talbot et al. 2005). Nothing if none of the few can contribute. The pool must not be empty.
std::optional<SelectedVertex> select_vertex(const LightVertexPool& pool,
                                            const LightSampleContext& at,
                                            std::uint32_t path,
                                            int bounce);

}  // namespace orbs::tracer

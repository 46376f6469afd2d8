#pragma once

#include "tracer/accel/openings.h"
#include "tracer/geometry/ray.h"
#include "tracer/geometry/render_object.h"
#include "tracer/light/emitter.h"
#include "tracer/plugins/plugin_shape.h"
#include "tracer/shapes/solid.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace orbs::tracer {

/// What rays can hit. The arrays must outlive the accelerator and must not move.
struct AccelGeometry {
  const std::vector<RenderObject>& objects;
  const std::vector<TriangleMesh>& meshes;
  const std::vector<SphereSurface>& spheres;
  const std::vector<Solid>& solids;
  const std::vector<PluginShape>& plugin_shapes;
  const std::vector<AreaLight>& lights;
  Openings openings;
};

/// The arithmetic of tests of rays against triangles. Double shows by comparison where rounding decides what
/// a path meets; places and shading are in single precision in either case.
enum class Intersection { Single, Double };

/// Whether rays that follow one another are close and alike in direction, as those of neighbouring camera
/// samples are. Only the traversal depends on it: the rays of a packet test boxes together, by a frustum
/// about all of them. The hits are the same, but that a ray through the common edge of two triangles may be
/// said to hit either.
enum class Coherence { None, Neighbours };

/// Ray traversal by Embree, in robust mode: no ray passes between adjacent triangles. Rays are traced in
/// packets of 16, which take two thirds of the time of single rays on small scenes; Embree itself falls back
/// to single rays where a packet diverges.
class Accel {
 public:
  explicit Accel(const AccelGeometry& geometry, Intersection intersection = Intersection::Single);
  ~Accel();
  Accel(const Accel&) = delete;
  Accel& operator=(const Accel&) = delete;
  Accel(Accel&&) = delete;
  Accel& operator=(Accel&&) = delete;

  /// The nearest hit of each ray; object = kNoHit if there is none.
  void intersect(std::span<const Ray> rays, std::span<Hit> hits, Coherence coherence = Coherence::None) const;
  /// 1 for rays that hit anything within their reach, else 0.
  void occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace orbs::tracer

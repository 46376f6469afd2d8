#pragma once

#include "tracer/accel/accel.h"
#include "tracer/world/world.h"

#include <span>

namespace orbs::tracer {

/// The nearest hits of rays, as Accel::intersect finds them, but for those that lie beside an edge of a mesh
/// at rest, where rounding decides on which side of another triangle a path goes on.
///
/// A ray that passes a ridge within its rounding may hit either of its triangles, also the one that it cannot
/// see: seen from there, the inside of a closed room is outside. So it is aimed once more, at a place that
/// keeps a distance from the edges (edge_distance.h), and what hides that place is the hit. In a narrow cleft
/// the origin of the next ray, offset along the normal, may lie behind the cleft's other side; where it does,
/// the hit moves to that place.
///
/// In a bumpy room 14 of 31 million paths left by these two ways; with this none does.
void nearest_hits(const World& world,
                  std::span<const Ray> rays,
                  std::span<Hit> hits,
                  Coherence coherence = Coherence::None);

}  // namespace orbs::tracer

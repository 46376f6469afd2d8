#pragma once

#include "tracer/accel/accel.h"
#include "tracer/world/world.h"

#include <span>

namespace orbs::tracer {

/// The nearest hits of rays, as Accel::intersect finds them, and on meshes at rest never on the far side of
/// an edge that the ray just misses.
///
/// A ray that passes a ridge within its rounding may hit either of its triangles, also the one that it cannot
/// see. Seen from there, the inside of a closed room is outside. So a ray that hits a triangle beside an edge
/// is aimed once more, at the place to which surface_point() moves the hit: it meets that place, or what
/// hides it.
void nearest_hits(const World& world,
                  std::span<const Ray> rays,
                  std::span<Hit> hits,
                  Coherence coherence = Coherence::None);

}  // namespace orbs::tracer

#include "tracer/shapes/csg.h"

#include "tracer/shapes/implicit_boundary.h"
#include "tracer/shapes/leaf_boundary.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace orbs::tracer {

namespace {

// Entries of the tables below. `Nearer` takes ties as A's.
enum class Entry {
  TakeNearer,
  AdvanceNearer,
  TakeA,
  TakeB,
  TakeAIfNearer,  // else advance B
  TakeBIfNearer,  // else advance A
  None
};

using Table = std::array<std::array<Entry, 3>, 3>;  // [crossing of A][crossing of B]: enter, exit, miss

// Crossing tells whether the ray is inside an operand now: it is where it exits next. The nearer boundary is
// taken where it changes whether the ray is inside the result, else passed. The idea and three tables are by
// Kensler 2006 (Ray Tracing CSG Objects Using Single Hit Intersections). Corrected here: in the union, from
// inside both, the nearer exit is passed, as that operand may begin again before the other one ends; and
// where one boundary is taken only if it is nearer, equal ones count as not nearer, so that coincident faces
// leave no surface behind.
constexpr Table kUnion{{{Entry::TakeNearer, Entry::TakeBIfNearer, Entry::TakeA},
                        {Entry::TakeAIfNearer, Entry::AdvanceNearer, Entry::TakeA},
                        {Entry::TakeB, Entry::TakeB, Entry::None}}};
constexpr Table kDifference{{{Entry::TakeAIfNearer, Entry::AdvanceNearer, Entry::TakeA},
                             {Entry::TakeNearer, Entry::TakeBIfNearer, Entry::TakeA},
                             {Entry::None, Entry::None, Entry::None}}};
constexpr Table kIntersection{{{Entry::AdvanceNearer, Entry::TakeAIfNearer, Entry::None},
                               {Entry::TakeBIfNearer, Entry::TakeNearer, Entry::None},
                               {Entry::None, Entry::None, Entry::None}}};

const Table& table_of(scene::SetOperation operation) {
  switch (operation) {
    case scene::SetOperation::Union:
      return kUnion;
    case scene::SetOperation::Difference:
      return kDifference;
    case scene::SetOperation::Intersection:
      return kIntersection;
  }
  return kUnion;
}

LocalRay local_ray(const SolidLeaf& leaf, const SolidRay& ray) {
  return {transform_point(leaf.to_local, ray.origin), transform_direction(leaf.to_local, ray.direction)};
}

BoundaryHit boundary_of_leaf(const Solid& solid, std::uint32_t index, const SolidRay& ray, double after) {
  const SolidLeaf& leaf = solid.leaves[index];
  const LocalRay local = local_ray(leaf, ray);
  const Roots roots = solid.nodes.size() == 1 ? Roots::All : Roots::SignChanges;
  BoundaryHit found;
  if (const auto* implicit = std::get_if<ImplicitLeaf>(&leaf.form))
    found = next_boundary(*implicit, local, after, roots, *solid.counts);
  else if (const auto* quadric = std::get_if<QuadricLeaf>(&leaf.form))
    found = next_boundary(*quadric, local, after);
  else if (const auto* box = std::get_if<BoxLeaf>(&leaf.form))
    found = next_boundary(*box, local, after);
  else if (const auto* disk = std::get_if<DiskLeaf>(&leaf.form))
    found = next_boundary(*disk, local, after);
  else
    found = next_boundary(std::get<HalfSpaceLeaf>(leaf.form), local, after);
  found.leaf = index;
  return found;
}

double tie_of(const SolidRay& ray, double t) {
  constexpr double kRounding = 0x1p-47;
  return kRounding * (largest_magnitude(ray.origin) / length(ray.direction) + std::abs(t));
}

class Traversal {
 public:
  Traversal(const Solid& solid, const SolidRay& ray) : solid_(solid), ray_(ray) {}

  BoundaryHit next(std::uint32_t index, double after) const {
    const SolidNode& node = solid_.nodes[index];
    if (node.leaf >= 0) return boundary_of_leaf(solid_, static_cast<std::uint32_t>(node.leaf), ray_, after);
    BoundaryHit a = next(node.a, after);
    BoundaryHit b = next(node.b, after);
    // Each step passes one boundary, and a ray has finitely many; the limit is for rounding to end at.
    constexpr int kMostSteps = 10'000;
    for (int i = 0; i < kMostSteps; ++i) {
      if (std::isinf(std::min(a.t, b.t))) return without_end(node.operation, a, b);
      switch (next_step(node.operation, a, b, tie_of(ray_, std::min(a.t, b.t)))) {
        case Verdict::TakeA:
          return a;
        case Verdict::TakeB:
          return node.operation == scene::SetOperation::Difference ? reversed(b) : b;
        case Verdict::AdvanceA:
          a = next(node.a, past(ray_, a.t));
          break;
        case Verdict::AdvanceB:
          b = next(node.b, past(ray_, b.t));
          break;
        case Verdict::Miss:
          return {};
      }
    }
    ++solid_.counts->unfinished;
    return {};
  }

 private:
  // Neither operand ends any more: the ray stays inside the result for ever, or outside.
  static BoundaryHit without_end(scene::SetOperation operation, const BoundaryHit& a, const BoundaryHit& b) {
    const bool in_a = a.crossing == Crossing::Exit;
    const bool in_b = b.crossing == Crossing::Exit;
    const bool is_inside = operation == scene::SetOperation::Union          ? in_a || in_b
                           : operation == scene::SetOperation::Intersection ? in_a && in_b
                                                                            : in_a && !in_b;
    BoundaryHit end;
    if (is_inside) end.crossing = Crossing::Exit;
    return end;
  }

  // What B enters, A - B leaves, with the normal turned into B.
  static BoundaryHit reversed(BoundaryHit b) {
    b.crossing = b.crossing == Crossing::Enter ? Crossing::Exit : Crossing::Enter;
    b.is_flipped = !b.is_flipped;
    return b;
  }

  const Solid& solid_;
  const SolidRay& ray_;
};

}  // namespace

Verdict next_step(scene::SetOperation operation, const BoundaryHit& a, const BoundaryHit& b, double tie) {
  const auto row = static_cast<std::size_t>(a.crossing);
  const auto column = static_cast<std::size_t>(b.crossing);
  switch (table_of(operation)[row][column]) {
    case Entry::TakeNearer:
      return a.t <= b.t ? Verdict::TakeA : Verdict::TakeB;
    case Entry::AdvanceNearer:
      return a.t <= b.t ? Verdict::AdvanceA : Verdict::AdvanceB;
    case Entry::TakeA:
      return Verdict::TakeA;
    case Entry::TakeB:
      return Verdict::TakeB;
    case Entry::TakeAIfNearer:
      return a.t < b.t - tie ? Verdict::TakeA : Verdict::AdvanceB;
    case Entry::TakeBIfNearer:
      return b.t < a.t - tie ? Verdict::TakeB : Verdict::AdvanceA;
    case Entry::None:
      break;
  }
  return Verdict::Miss;
}

double past(const SolidRay& ray, double t) { return t + tie_of(ray, t); }

BoundaryHit next_boundary(const Solid& solid, const SolidRay& ray, double after) {
  return Traversal(solid, ray).next(static_cast<std::uint32_t>(solid.nodes.size() - 1), after);
}

}  // namespace orbs::tracer

#include "tracer/shapes/csg.h"

#include "tracer/numeric_fault.h"
#include "tracer/shapes/implicit_boundary.h"
#include "tracer/shapes/solid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace orbs::tracer {

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

struct End {
  double t = 0;
  std::uint8_t face = kOwnFace;
};

// The part of a ray within a solid; nothing where it ends before it begins.
struct Span {
  End enter{-kInf};
  End exit{kInf};
};

bool is_nothing(const Span& span) { return !(span.enter.t < span.exit.t); }

Span common(const Span& a, const Span& b) {
  return {a.enter.t >= b.enter.t ? a.enter : b.enter, a.exit.t <= b.exit.t ? a.exit : b.exit};
}

// Between two planes perpendicular to an axis.
Span slab(double origin, double direction, const End& low, const End& high) {
  if (direction == 0) {
    const bool is_inside = origin >= low.t && origin <= high.t;
    return is_inside ? Span{} : Span{{kInf}, {-kInf}};
  }
  const double p = (low.t - origin) / direction;
  const double q = (high.t - origin) / direction;
  return p < q ? Span{{p, low.face}, {q, high.face}} : Span{{q, high.face}, {p, low.face}};
}

BoundaryHit boundary(const End& end, Crossing crossing) { return {end.t, crossing, 0, end.face, false}; }

// The first end of the spans, which are in order, beyond `after`.
BoundaryHit first_end(const std::array<Span, 2>& spans, double after) {
  for (const Span& span : spans) {
    if (is_nothing(span)) continue;
    if (span.enter.t > after) return boundary(span.enter, Crossing::Enter);
    if (span.exit.t > after) return boundary(span.exit, Crossing::Exit);
  }
  return {};
}

// Where p t^2 + 2 q t + r <= 0, as at most two spans in order.
std::array<Span, 2> below_zero(double p, double q, double r) {
  const Span none{{kInf}, {-kInf}};
  if (p == 0 && q == 0) return {r <= 0 ? Span{} : none, none};
  if (p == 0) {
    const double t = -r / (2 * q);
    return {q > 0 ? Span{{-kInf}, {t}} : Span{{t}, {kInf}}, none};
  }
  const double discriminant = q * q - p * r;
  if (!(discriminant > 0)) return {p < 0 ? Span{} : none, none};
  // The larger root first and the other from the product of both, as one of -q +- root cancels.
  const double sum = -(q + std::copysign(std::sqrt(discriminant), q));
  double near = sum / p;
  double far = r / sum;
  if (near > far) std::swap(near, far);
  if (p > 0) return {Span{{near}, {far}}, none};
  return {Span{{-kInf}, {near}}, Span{{far}, {kInf}}};
}

// The open surface of a quadric between its ends: every end of a span that is not a cap.
BoundaryHit first_own_face(const std::array<Span, 2>& spans, double after) {
  for (const Span& span : spans) {
    if (is_nothing(span)) continue;
    if (span.enter.t > after && span.enter.face == kOwnFace) return boundary(span.enter, Crossing::Enter);
    if (span.exit.t > after && span.exit.face == kOwnFace) return boundary(span.exit, Crossing::Exit);
  }
  return {};
}

// The nearest boundary of a leaf beyond `after`, strictly. Its t does not depend on `after`, so that a
// caller who passes it gets the next one. A half-space that the ray never leaves is left at infinity.
// BoundaryHit::leaf stays 0.
BoundaryHit next_boundary(const QuadricLeaf& leaf, const LocalRay& ray, double after) {
  const auto& s = leaf.quadric;
  // Solved from the point nearest to the middle of the shape, as b^2 - 4ac cancels for distant origins
  // (Haines et al. 2019, Ray Tracing Gems, ch. 7).
  const Vec3d middle = leaf.is_sphere ? Vec3d{} : Vec3d{0, (s.y_low + s.y_high) / 2, 0};
  const Vec3d d = ray.direction;
  const bool is_naive = leaf.is_sphere && has_fault(NumericFault::NaiveQuadratic);
  const double start = is_naive ? 0 : dot(middle - ray.origin, d) / dot(d, d);
  const Vec3d o = point_at(ray, start);
  const double p = d.x * d.x + d.z * d.z - s.c * d.y * d.y;
  const double q = o.x * d.x + o.z * d.z - (s.b / 2 + s.c * o.y) * d.y;
  double r = o.x * o.x + o.z * o.z - s.a - o.y * (s.b + s.c * o.y);
  if (is_naive) r = static_cast<double>(static_cast<float>(dot(o, o)) - static_cast<float>(s.a));
  auto spans = below_zero(p, q, r);
  if (!leaf.is_sphere) {
    const Span between = slab(o.y, d.y, {s.y_low, box_face(1, false)}, {s.y_high, box_face(1, true)});
    for (Span& span : spans) span = common(span, between);
  }
  for (Span& span : spans) {
    span.enter.t += start;
    span.exit.t += start;
  }
  return leaf.is_sphere || s.has_caps ? first_end(spans, after) : first_own_face(spans, after);
}

BoundaryHit next_boundary(const DiskLeaf& leaf, const LocalRay& ray, double after) {
  const double t = -ray.origin.y / ray.direction.y;
  if (!(t > after && t < kInf)) return {};
  const Vec3d p = point_at(ray, t);
  if (p.x * p.x + p.z * p.z > leaf.radius * leaf.radius) return {};
  return {t, ray.direction.y < 0 ? Crossing::Enter : Crossing::Exit, 0, box_face(1, true), false};
}

BoundaryHit next_boundary(const BoxLeaf& leaf, const LocalRay& ray, double after) {
  const Vec3d h = leaf.half_sizes;
  const auto side = [](int axis, double origin, double direction, double half) {
    return slab(origin, direction, {-half, box_face(axis, false)}, {half, box_face(axis, true)});
  };
  const Span inside =
      common(common(side(0, ray.origin.x, ray.direction.x, h.x), side(1, ray.origin.y, ray.direction.y, h.y)),
             side(2, ray.origin.z, ray.direction.z, h.z));
  return first_end({inside, Span{{kInf}, {-kInf}}}, after);
}

BoundaryHit next_boundary(const HalfSpaceLeaf&, const LocalRay& ray, double after) {
  const double t = -ray.origin.y / ray.direction.y;
  const std::uint8_t face = box_face(1, true);
  if (ray.direction.y < 0 && t > after) return {t, Crossing::Enter, 0, face, false};
  if (ray.direction.y > 0) return t > after ? BoundaryHit{t, Crossing::Exit, 0, face, false} : BoundaryHit{};
  const bool is_inside = ray.direction.y < 0 || ray.origin.y < 0;
  // A miss while inside would read as outside.
  return is_inside ? BoundaryHit{kInf, Crossing::Exit, 0, face, false} : BoundaryHit{};
}

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

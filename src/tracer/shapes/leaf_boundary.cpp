#include "tracer/shapes/leaf_boundary.h"

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

}  // namespace

BoundaryHit next_boundary(const QuadricLeaf& leaf, const LocalRay& ray, double after) {
  const auto& s = leaf.quadric;
  // Solved from the point nearest to the middle of the shape, as b^2 - 4ac cancels for distant origins
  // (Haines et al. 2019, Ray Tracing Gems, ch. 7).
  const Vec3d middle = leaf.is_sphere ? Vec3d{} : Vec3d{0, (s.y_low + s.y_high) / 2, 0};
  const Vec3d d = ray.direction;
  const double start = dot(middle - ray.origin, d) / dot(d, d);
  const Vec3d o = point_at(ray, start);
  const double p = d.x * d.x + d.z * d.z - s.c * d.y * d.y;
  const double q = o.x * d.x + o.z * d.z - (s.b / 2 + s.c * o.y) * d.y;
  const double r = o.x * o.x + o.z * o.z - s.a - o.y * (s.b + s.c * o.y);
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

}  // namespace orbs::tracer

#include "tracer/shapes/implicit_boundary.h"

#include "scene/shapes/dual.h"
#include "scene/shapes/enclosure.h"
#include "scene/shapes/expression.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace orbs::tracer {

namespace {

using scene::Enclosure;
using scene::Expression;
using scene::Slope;

// Most evaluations for one boundary. The Barth decic takes some 100; what needs more than this has infinitely
// many roots, as sin(1 / x).
constexpr int kMostEvaluations = 100'000;

// Working memory of the evaluations, one for each thread: it grows to the longest formula.
template <typename N>
std::span<N> working_memory(const Expression& expression) {
  thread_local std::vector<N> values;
  if (values.size() < expression.steps.size()) values.resize(expression.steps.size());
  return values;
}

// f along a ray.
class RayFunction {
 public:
  RayFunction(const Expression& expression, const LocalRay& ray)
      : expression_(expression),
        ray_(ray),
        numbers_(working_memory<double>(expression)),
        enclosures_(working_memory<Enclosure>(expression)),
        slopes_(working_memory<Slope>(expression)) {}

  double at(double t) const {
    const Vec3d p = point_at(ray_, t);
    return scene::evaluate<double>(expression_, {p.x, p.y, p.z}, numbers_);
  }
  Enclosure within(const Enclosure& t) const {
    const auto along = [&](double o, double d) { return Enclosure(o) + Enclosure(d) * t; };
    return scene::evaluate<Enclosure>(
        expression_,
        {along(ray_.origin.x, ray_.direction.x), along(ray_.origin.y, ray_.direction.y),
         along(ray_.origin.z, ray_.direction.z)},
        enclosures_);
  }
  Slope slope_within(const Enclosure& t) const {
    const auto along = [&](double o, double d) {
      return Slope{Enclosure(o) + Enclosure(d) * t, Enclosure(d)};
    };
    return scene::evaluate<Slope>(
        expression_,
        {along(ray_.origin.x, ray_.direction.x), along(ray_.origin.y, ray_.direction.y),
         along(ray_.origin.z, ray_.direction.z)},
        slopes_);
  }
  // The sign by enclosure; where rounding hides it, that of the value in double. One answer for one t, so
  // that neighbouring parts agree about their common end.
  bool is_inside(double t) const {
    const Enclosure f = within(Enclosure(t));
    if (f.high < 0) return true;
    return f.low <= 0 && at(t) < 0;
  }

 private:
  const Expression& expression_;
  const LocalRay& ray_;
  std::span<double> numbers_;
  std::span<Enclosure> enclosures_;
  std::span<Slope> slopes_;
};

// The root of a function that changes its sign once between a and b, to neighbouring doubles: regula falsi
// (Illinois; Dowell, Jarratt 1971), and every third step a halving, as the steps may shrink one side only.
double refine(const RayFunction& f, double a, double b, bool inside_at_a) {
  double fa = f.at(a);
  double fb = f.at(b);
  int last_side = 0;
  for (int i = 0;; ++i) {
    double middle = a + (b - a) / 2;
    if (!(middle > a && middle < b)) return b;
    const double secant = b - fb * (b - a) / (fb - fa);
    if (i % 3 != 2 && secant > a && secant < b) middle = secant;
    const double fm = f.at(middle);
    if (fm == 0) return middle;
    const int side = (fm < 0) == inside_at_a ? -1 : 1;
    (side < 0 ? a : b) = middle;
    (side < 0 ? fa : fb) = fm;
    if (side == last_side) (side < 0 ? fb : fa) /= 2;
    last_side = side;
  }
}

struct BoxSpan {
  double enter = 0;
  double exit = 0;
  std::uint8_t enter_face = kOwnFace;
  std::uint8_t exit_face = kOwnFace;
};

void cut(BoxSpan& span, int axis, double origin, double direction, double low, double high) {
  if (direction == 0) {
    if (origin < low || origin > high) span.exit = -std::numeric_limits<double>::infinity();
    return;
  }
  double p = (low - origin) / direction;
  double q = (high - origin) / direction;
  const bool is_turned = p > q;
  if (is_turned) std::swap(p, q);
  if (p > span.enter) {
    span.enter = p;
    span.enter_face = box_face(axis, is_turned);
  }
  if (q < span.exit) {
    span.exit = q;
    span.exit_face = box_face(axis, !is_turned);
  }
}

BoxSpan box_span(const scene::ImplicitForm& form, const LocalRay& ray) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  BoxSpan span{-kInf, kInf};
  cut(span, 0, ray.origin.x, ray.direction.x, form.low_m.x, form.high_m.x);
  cut(span, 1, ray.origin.y, ray.direction.y, form.low_m.y, form.high_m.y);
  cut(span, 2, ray.origin.z, ray.direction.z, form.low_m.z, form.high_m.z);
  return span;
}

// Parts of the ray that are left to search, the nearest on top. Each halving adds one part.
struct Parts {
  std::array<std::array<double, 2>, 128> list;
  std::size_t count = 0;
  void push(double a, double b) { list[count++] = {a, b}; }
  std::array<double, 2> pop() { return list[--count]; }
};

// What is known of one part of the ray.
enum class Part { NoRoot, OneRoot, Unknown };

Part examine(const RayFunction& f, double a, double middle, double b, bool& is_bounded) {
  // The value alone takes a third of the time of both, and rules out half of the parts.
  if (!scene::holds_zero(f.within({a, b}))) return Part::NoRoot;
  const Slope s = f.slope_within({a, b});
  is_bounded = scene::is_bounded(s.value);
  if (!scene::holds_zero(s.value)) return Part::NoRoot;
  if (scene::is_bounded(s.derivative)) {
    if (!scene::holds_zero(s.derivative)) return Part::OneRoot;  // or none: the ends tell
    const Enclosure centred =
        f.within(Enclosure(middle)) + s.derivative * (Enclosure(a, b) - Enclosure(middle));
    if (!scene::holds_zero(centred)) return Part::NoRoot;
  }
  return Part::Unknown;
}

Crossing crossing_into(bool is_inside) { return is_inside ? Crossing::Enter : Crossing::Exit; }

// The first root between the ends of the span and beyond `after`. The halving starts from the span and
// not from `after`, so that a root is the same number each time.
std::optional<BoundaryHit> first_root(const RayFunction& f,
                                      const BoxSpan& span,
                                      double shortest,
                                      double after,
                                      Roots roots,
                                      RootCounts& counts) {
  Parts parts;
  parts.push(span.enter, span.exit);
  for (int evaluations = 0; parts.count > 0; ++evaluations) {
    const auto [a, b] = parts.pop();
    if (!(b > after)) continue;
    if (evaluations == kMostEvaluations) {
      ++counts.unfinished;
      return BoundaryHit{std::max(a, after), Crossing::Enter};
    }
    const double middle = a + (b - a) / 2;
    bool is_bounded = true;
    const Part part = examine(f, a, middle, b, is_bounded);
    if (part == Part::NoRoot) continue;
    const bool is_shortest =
        b - a <= shortest || !(middle > a && middle < b) || parts.count + 2 > parts.list.size();
    if (part == Part::Unknown && !is_shortest) {
      parts.push(middle, b);
      parts.push(a, middle);
      continue;
    }
    if (part == Part::Unknown && !is_bounded)
      continue;  // a pole: f is no surface where it jumps through infinity
    const bool inside_at_a = f.is_inside(a);
    if (inside_at_a != f.is_inside(b)) {
      const double t = refine(f, a, b, inside_at_a);
      if (t > after) return BoundaryHit{t, crossing_into(!inside_at_a)};
    } else if (part == Part::Unknown && roots == Roots::All && middle > after) {
      ++counts.undecided;
      return BoundaryHit{middle, Crossing::Enter};
    }
  }
  return std::nullopt;
}

// The shortest part of the ray that is halved: there the rounding of the point is as large as the part.
double shortest_part(const LocalRay& ray, const BoxSpan& span) {
  const double reach = std::max(std::abs(span.enter), std::abs(span.exit));
  return 0x1p-50 * (reach + largest_magnitude(ray.origin) / length(ray.direction));
}

}  // namespace

BoundaryHit next_boundary(
    const ImplicitLeaf& leaf, const LocalRay& ray, double after, Roots roots, RootCounts& counts) {
  if (counts.unfinished.load(std::memory_order_relaxed) > kMostUnfinished) return {};
  const BoxSpan span = box_span(leaf.form, ray);
  if (!(span.enter < span.exit) || !(span.exit > after)) return {};
  const RayFunction f(leaf.form.expression, ray);
  const bool is_closed = leaf.form.is_closed;
  if (is_closed && span.enter > after && f.is_inside(span.enter))
    return {span.enter, Crossing::Enter, 0, span.enter_face, false};
  if (const auto root = first_root(f, span, shortest_part(ray, span), after, roots, counts)) return *root;
  if (is_closed && f.is_inside(span.exit)) return {span.exit, Crossing::Exit, 0, span.exit_face, false};
  return {};
}

std::optional<Vec3d> implicit_normal(const Expression& expression, Vec3d point) {
  const auto gradient_at = [&](Vec3d p) {
    using scene::Gradient;
    const auto gradient =
        scene::evaluate<Gradient>(expression, {{p.x, {1, 0, 0}}, {p.y, {0, 1, 0}}, {p.z, {0, 0, 1}}},
                                  working_memory<Gradient>(expression));
    return gradient.derivative;
  };
  // By the largest component: squares of those below 1e-162 are zero in double.
  const auto is_usable = [](Vec3d g) { return is_finite(g) && largest_magnitude(g) > 0; };
  const Vec3d gradient = gradient_at(point);
  if (is_usable(gradient)) return normalised(gradient / largest_magnitude(gradient));
  // Unequal steps: gradients at opposite points around a node cancel.
  const double step = 1e-6 * std::max(largest_magnitude(point), 1e-6);
  for (const Vec3d side : {Vec3d{1, 0.6, 0.3}, Vec3d{-0.4, 1, 0.7}, Vec3d{0.2, -0.5, 1}})
    if (const Vec3d g = gradient_at(point + side * step); is_usable(g))
      return normalised(g / largest_magnitude(g));
  return std::nullopt;
}

}  // namespace orbs::tracer

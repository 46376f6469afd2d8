#include "scene/shapes/formula_range.h"

#include "scene/shapes/enclosure.h"

#include <cmath>
#include <vector>

namespace orbs::scene {

namespace {

// Calls is_found(low, high) for side^3 equal parts of the box until it is true.
template <typename IsFound>
bool any_part(Vec3d low, Vec3d high, int side, IsFound is_found) {
  const Vec3d step{(high.x - low.x) / side, (high.y - low.y) / side, (high.z - low.z) / side};
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j)
      for (int k = 0; k < side; ++k) {
        const Vec3d from{low.x + i * step.x, low.y + j * step.y, low.z + k * step.z};
        if (is_found(from, from + step)) return true;
      }
  return false;
}

}  // namespace

bool has_values(const Expression& expression, Vec3d low, Vec3d high) {
  // The middles of parts lie on planes of symmetry, where a formula may have a pole.
  constexpr double kWithin = 0.381966;
  std::vector<double> numbers(expression.steps.size());
  const auto is_finite_at = [&](Vec3d from, Vec3d to) {
    const Vec3d p = from + (to - from) * kWithin;
    return std::isfinite(evaluate<double>(expression, {p.x, p.y, p.z}, numbers));
  };
  if (any_part(low, high, 16, is_finite_at)) return true;
  std::vector<Enclosure> enclosures(expression.steps.size());
  return any_part(low, high, 8, [&](Vec3d from, Vec3d to) {
    const auto f = evaluate<Enclosure>(
        expression, {Enclosure(from.x, to.x), Enclosure(from.y, to.y), Enclosure(from.z, to.z)}, enclosures);
    return !is_empty(f) && is_bounded(f);
  });
}

}  // namespace orbs::scene

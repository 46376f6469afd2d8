#include "tracer/shapes/build_solids.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace orbs::tracer {

namespace {

struct Bounds {
  Vec3d low;
  Vec3d high;
};

Vec3d lower(Vec3d a, Vec3d b) { return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}; }
Vec3d upper(Vec3d a, Vec3d b) { return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}; }

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr Bounds kAll{{-kInf, -kInf, -kInf}, {kInf, kInf, kInf}};

double largest_radius(const scene::RevolvedQuadric& q) {
  const auto squared = [&](double y) { return q.a + y * (q.b + y * q.c); };
  double largest = std::max(squared(q.y_low), squared(q.y_high));
  const double top = q.c < 0 ? -q.b / (2 * q.c) : q.y_low;
  if (top > q.y_low && top < q.y_high) largest = std::max(largest, squared(top));
  return std::sqrt(largest);
}

Bounds box_about(double radius, double low, double high) {
  return {{-radius, low, -radius}, {radius, high, radius}};
}

struct LocalBounds {
  Bounds operator()(const QuadricLeaf& leaf) const {
    if (leaf.is_sphere)
      return box_about(std::sqrt(leaf.quadric.a), -std::sqrt(leaf.quadric.a), std::sqrt(leaf.quadric.a));
    return box_about(largest_radius(leaf.quadric), leaf.quadric.y_low, leaf.quadric.y_high);
  }
  Bounds operator()(const DiskLeaf& leaf) const { return box_about(leaf.radius, 0, 0); }
  Bounds operator()(const BoxLeaf& leaf) const { return {-leaf.half_sizes, leaf.half_sizes}; }
  Bounds operator()(const HalfSpaceLeaf&) const { return kAll; }
  Bounds operator()(const ImplicitLeaf& leaf) const { return {leaf.form.low_m, leaf.form.high_m}; }
};

Bounds world_bounds(const SolidLeaf& leaf) {
  const Bounds local = std::visit(LocalBounds{}, leaf.form);
  if (std::isinf(local.low.x)) return kAll;
  Bounds world{kAll.high, kAll.low};
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3d p{(corner & 1) != 0 ? local.high.x : local.low.x,
                  (corner & 2) != 0 ? local.high.y : local.low.y,
                  (corner & 4) != 0 ? local.high.z : local.low.z};
    const Vec3d q = transform_point(leaf.to_world, p);
    world = {lower(world.low, q), upper(world.high, q)};
  }
  return world;
}

double size_of(const SolidLeaf& leaf, const Bounds& world) {
  if (std::isinf(world.low.x)) return largest_magnitude(transform_point(leaf.to_world, {}));
  return std::max(largest_magnitude(world.low), largest_magnitude(world.high));
}

Bounds combined(scene::SetOperation operation, const Bounds& a, const Bounds& b) {
  switch (operation) {
    case scene::SetOperation::Union:
      return {lower(a.low, b.low), upper(a.high, b.high)};
    case scene::SetOperation::Intersection:
      return {upper(a.low, b.low), lower(a.high, b.high)};
    case scene::SetOperation::Difference:
      break;
  }
  return a;
}

class Builder {
 public:
  // Returns the index of the node.
  std::uint32_t add(const scene::Shape& shape, const Mat4& to_world, int material) {
    const Mat4 matrix = to_world * shape.matrix;
    const int own = shape.material < 0 ? material : shape.material;
    const auto* csg = std::get_if<scene::CsgForm>(&shape.form);
    if (csg == nullptr) return add_leaf(shape.form, matrix, own);
    std::uint32_t result = add(csg->operands.front(), matrix, own);
    for (std::size_t i = 1; i < csg->operands.size(); ++i)
      result = add_node(csg->operation, result, add(csg->operands[i], matrix, own));
    return result;
  }

  Solid take() {
    // Room for the rounding of bounds and rays to floats: a shape of this world is at most 1e6 of these away.
    const Bounds& all = bounds_.back();
    const double size = std::max(largest_magnitude(all.low), largest_magnitude(all.high));
    const Vec3d room{size * 1e-6, size * 1e-6, size * 1e-6};
    // An intersection of solids that lie apart has no inside: any bounds will do, but not turned ones.
    solid_.low = all.low - room;
    solid_.high = upper(all.high + room, solid_.low);
    return std::move(solid_);
  }

 private:
  std::uint32_t add_node(scene::SetOperation operation, std::uint32_t a, std::uint32_t b) {
    solid_.nodes.push_back({-1, operation, a, b});
    bounds_.push_back(combined(operation, bounds_[a], bounds_[b]));
    return static_cast<std::uint32_t>(solid_.nodes.size() - 1);
  }

  std::uint32_t add_leaf(const scene::ShapeForm& form, const Mat4& matrix, int material) {
    SolidLeaf leaf = std::visit([](const auto& f) { return leaf_of(f); }, form);
    leaf.to_world = matrix * leaf.to_world;
    leaf.to_local = inverse(leaf.to_world).value();  // the loader lets only invertible matrices through
    leaf.material = material;
    bounds_.push_back(world_bounds(leaf));
    leaf.size = size_of(leaf, bounds_.back());
    solid_.leaves.push_back(std::move(leaf));
    solid_.nodes.push_back({static_cast<int>(solid_.leaves.size() - 1)});
    return static_cast<std::uint32_t>(solid_.nodes.size() - 1);
  }

  template <typename F>
  static SolidLeaf leaf_of(const F& form) {
    if constexpr (requires { revolved(form); })
      return {.form = QuadricLeaf{revolved(form)}, .to_local = {}, .to_world = {}};
    else
      return {.form = ImplicitLeaf{implicit(form)}, .to_local = {}, .to_world = {}};
  }
  static SolidLeaf leaf_of(const scene::SphereForm& f) {
    const double r = f.radius_m;
    return {.form = QuadricLeaf{{r * r, 0, -1, 0, 0, false}, true},
            .to_local = {},
            .to_world = translation(f.centre_m)};
  }
  static SolidLeaf leaf_of(const scene::DiskForm& f) {
    return {.form = DiskLeaf{f.radius_m}, .to_local = {}, .to_world = {}};
  }
  static SolidLeaf leaf_of(const scene::BoxForm& f) {
    return {.form = BoxLeaf{f.half_sizes_m}, .to_local = {}, .to_world = {}};
  }
  static SolidLeaf leaf_of(const scene::HalfSpaceForm&) {
    return {.form = HalfSpaceLeaf{}, .to_local = {}, .to_world = {}};
  }
  static SolidLeaf leaf_of(const scene::TorusForm& f) {
    return {.form = ImplicitLeaf{implicit(f), f}, .to_local = {}, .to_world = {}};
  }
  static SolidLeaf leaf_of(const scene::PluginForm&) { std::abort(); }  // is no solid: add_plugin_shapes
  static SolidLeaf leaf_of(const scene::CsgForm&) { std::abort(); }     // add() does not come here with CSG

  Solid solid_;
  std::vector<Bounds> bounds_;  // of the nodes
};

}  // namespace

Solid make_solid(const scene::Shape& shape, Vec3d origin) {
  Builder builder;
  builder.add(shape, translation(-origin), shape.material);
  auto solid = builder.take();
  solid.name = shape.name;
  return solid;
}

void refuse_unfinished_shapes(const std::vector<Solid>& solids) {
  for (std::size_t i = 0; i < solids.size(); ++i)
    if (solids[i].counts->unfinished > kMostUnfinished)
      throw InputError(fmt::format(
          "{}: the search for its surface did not end on more than {} rays: its formula has no value, or infinitely "
          "many roots or poles there, as x / (y - y) or sin(1 / x); make the formula finite, or its box smaller",
          scene::display_name("shape", solids[i].name, i), kMostUnfinished));
}

}  // namespace orbs::tracer

#include "tracer/shapes/solid_hit.h"

#include "tracer/shapes/implicit_boundary.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace orbs::tracer {

namespace {

// Hit::primitive: bit 0 whether the normal is flipped, bits 1 to 3 the face, the leaf above.
std::uint32_t primitive_of(const BoundaryHit& boundary) {
  return boundary.leaf << 4 | static_cast<std::uint32_t>(boundary.face) << 1 |
         (boundary.is_flipped ? 1U : 0U);
}
std::uint32_t leaf_of(const Hit& hit) { return hit.primitive >> 4; }
std::uint8_t face_of(const Hit& hit) { return static_cast<std::uint8_t>(hit.primitive >> 1 & 7U); }
bool is_flipped(const Hit& hit) { return (hit.primitive & 1U) != 0; }

Vec3d normal_of_face(std::uint8_t face) {
  const double side = face % 2 == 0 ? 1 : -1;
  return {face < 3 ? side : 0, face == 3 || face == 4 ? side : 0, face > 4 ? side : 0};
}

struct LocalNormal {
  Vec3d p;
  RootCounts& counts;

  // Half the gradient of x^2 + z^2 - a - b y - c y^2. At the apex of a cone it is zero.
  Vec3d operator()(const QuadricLeaf& leaf) const {
    const Vec3d gradient{p.x, -(leaf.quadric.b / 2 + leaf.quadric.c * p.y), p.z};
    return dot(gradient, gradient) > 0 ? gradient : Vec3d{0, 1, 0};
  }
  Vec3d operator()(const ImplicitLeaf& leaf) const {
    if (const auto normal = implicit_normal(leaf.form.expression, p)) return *normal;
    ++counts.zero_normals;
    return {0, 1, 0};
  }
  // These have numbered faces only.
  Vec3d operator()(const DiskLeaf&) const { return {0, 1, 0}; }
  Vec3d operator()(const BoxLeaf&) const { return {0, 1, 0}; }
  Vec3d operator()(const HalfSpaceLeaf&) const { return {0, 1, 0}; }
};

// From 0 at +z towards +x, as that of a sphere.
double around_y(Vec3d p) {
  const double turn = std::atan2(p.x, p.z) / (2 * std::numbers::pi);
  return turn < 0 ? turn + 1 : turn;
}

double latitude(Vec3d p) { return 0.5 + std::atan2(p.y, std::hypot(p.x, p.z)) / std::numbers::pi; }

Vec2d on_box(Vec3d p, Vec3d low, Vec3d high, std::uint8_t face) {
  const Vec3d size = high - low;
  const Vec3d q = (p - low) * Vec3d{1 / size.x, 1 / size.y, 1 / size.z};
  if (face < 3) return {q.z, q.y};
  return face < 5 ? Vec2d{q.x, q.z} : Vec2d{q.x, q.y};
}

struct TextureCoordinates {
  Vec3d p;
  std::uint8_t face;

  Vec2d operator()(const QuadricLeaf& leaf) const {
    const auto& q = leaf.quadric;
    if (leaf.is_sphere) return {around_y(p), latitude(p)};
    if (face == kOwnFace) return {around_y(p), (p.y - q.y_low) / (q.y_high - q.y_low)};
    const double y = face == box_face(1, false) ? q.y_low : q.y_high;
    return {around_y(p), std::hypot(p.x, p.z) / std::sqrt(q.a + y * (q.b + y * q.c))};
  }
  Vec2d operator()(const DiskLeaf& leaf) const { return {around_y(p), std::hypot(p.x, p.z) / leaf.radius}; }
  Vec2d operator()(const BoxLeaf& leaf) const { return on_box(p, -leaf.half_sizes, leaf.half_sizes, face); }
  Vec2d operator()(const HalfSpaceLeaf&) const { return {p.x, p.z}; }
  Vec2d operator()(const ImplicitLeaf& leaf) const {
    if (face != kOwnFace) return on_box(p, leaf.form.low_m, leaf.form.high_m, face);
    if (!leaf.torus) return {around_y(p), latitude(p)};
    const double tube =
        std::atan2(p.y, std::hypot(p.x, p.z) - leaf.torus->major_radius_m) / (2 * std::numbers::pi);
    return {around_y(p), tube < 0 ? tube + 1 : tube};
  }
};

}  // namespace

std::optional<Hit> intersect(const Solid& solid, Vec3f origin, Vec3f direction, float near, float far) {
  const SolidRay ray{cast<double>(origin), cast<double>(direction)};
  const BoundaryHit found = next_boundary(solid, ray, near);
  if (!(found.t < far)) return std::nullopt;
  Hit hit;
  hit.distance = static_cast<float>(found.t);
  hit.barycentric = {static_cast<float>(found.t - static_cast<double>(hit.distance)), 0};
  hit.primitive = primitive_of(found);
  return hit;
}

SolidPoint point_on_solid(const Solid& solid, const Ray& ray, const Hit& hit) {
  const double t = static_cast<double>(hit.distance) + static_cast<double>(hit.barycentric.x);
  const SolidLeaf& leaf = solid.leaves[leaf_of(hit)];
  SolidPoint out;
  out.material = leaf.material;
  out.position = cast<double>(ray.origin) + cast<double>(ray.direction) * t;
  const Vec3d local = transform_point(leaf.to_local, out.position);
  const Vec3d normal = face_of(hit) == kOwnFace ? std::visit(LocalNormal{local, *solid.counts}, leaf.form)
                                                : normal_of_face(face_of(hit));
  out.normal = normalised(transform_normal(leaf.to_local, normal));
  if (is_flipped(hit)) out.normal = -out.normal;
  out.error = kDoubleRounding * leaf.size;
  return out;
}

Vec2f texture_coordinates(const Solid& solid, const Hit& hit, Vec3f position) {
  const SolidLeaf& leaf = solid.leaves[leaf_of(hit)];
  const Vec3d local = transform_point(leaf.to_local, cast<double>(position));
  const Vec2d uv = std::visit(TextureCoordinates{local, face_of(hit)}, leaf.form);
  return {static_cast<float>(uv.x), static_cast<float>(uv.y)};
}

}  // namespace orbs::tracer

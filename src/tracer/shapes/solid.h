#pragma once

#include "base/matrix.h"
#include "scene/shapes/shape.h"

#include <atomic>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// Shapes by their formula, as rays meet them. All in double precision: a ray that starts on a surface, and
/// the difference of two nearly equal terms, leave few digits of a float.
namespace orbs::tracer {

struct LocalRay {
  Vec3d origin;
  Vec3d direction;  // of any length; the parameter t is that of the ray in world space
};

inline Vec3d point_at(const LocalRay& ray, double t) { return ray.origin + ray.direction * t; }

/// Where a ray passes through the boundary of a solid, or of an open surface.
enum class Crossing { Enter, Exit, Miss };

struct BoundaryHit {
  double t = std::numeric_limits<double>::infinity();
  Crossing crossing = Crossing::Miss;
  std::uint32_t leaf = 0;  // index into Solid::leaves
  std::uint8_t face = 0;   // of the leaf; kOwnFace or one of the faces that cut it
  bool is_flipped =
      false;  // the normal of the result is opposite to that of the leaf: inside of a difference
};

/// The surface of the formula itself. Other faces are numbered from 1: caps and the sides of boxes.
constexpr std::uint8_t kOwnFace = 0;

/// Faces of a box: 1 + 2 axis, plus 1 for the high side.
constexpr std::uint8_t box_face(int axis, bool is_high) {
  return static_cast<std::uint8_t>(1 + 2 * axis + (is_high ? 1 : 0));
}

/// x^2 + z^2 = a + b y + c y^2 between two heights, or without ends where they are infinite (spheres).
struct QuadricLeaf {
  scene::RevolvedQuadric quadric;
  bool is_sphere = false;
};
struct DiskLeaf {
  double radius = 1;
};
struct BoxLeaf {
  Vec3d half_sizes;
};
struct HalfSpaceLeaf {};
struct ImplicitLeaf {
  scene::ImplicitForm form;
  std::optional<scene::TorusForm> torus = {};  // whose texture coordinates it has
};

struct SolidLeaf {
  std::variant<QuadricLeaf, DiskLeaf, BoxLeaf, HalfSpaceLeaf, ImplicitLeaf> form;
  Mat4 to_local;
  Mat4 to_world;
  int material = 0;
  double size = 0;  // largest coordinate of its bounds in world space, or of a half-space's place
};

/// A leaf, or two nodes and what is made of them. Children come before their parents.
struct SolidNode {
  int leaf = -1;  // -1: not a leaf
  scene::SetOperation operation = scene::SetOperation::Union;
  std::uint32_t a = 0;
  std::uint32_t b = 0;
};

/// What could not be told of formulas. Sums of all rays, so that they do not depend on threads.
struct RootCounts {
  /// Parts of rays as short as rounding allows in which neither a root nor its absence could be shown; they
  /// count as hits, so that no surface is lost.
  std::atomic<std::uint64_t> undecided{0};
  /// Rays whose search ended at its limit; they end where the undecided rest begins.
  std::atomic<std::uint64_t> unfinished{0};
  /// Points without a gradient, and with none close by: they have a normal that is none of theirs.
  std::atomic<std::uint64_t> zero_normals{0};
};

/// One shape of the scene. `nodes` ends with the root.
struct Solid {
  std::string name;
  std::vector<SolidLeaf> leaves;
  std::vector<SolidNode> nodes;
  Vec3d low;  // bounds in world space
  Vec3d high;
  std::unique_ptr<RootCounts> counts = std::make_unique<RootCounts>();
};

/// Each unfinished search takes 10 ms and more. Where a shape has had so many of them, the rest of its rays
/// miss, so that the render ends soon, and its image is refused (build_solids.h): y - sin(1 / x),
/// seen from all sides, has a few; x / (y - y) has one for every ray. The sum of all threads decides, so it
/// is the same for any number of them.
constexpr std::uint64_t kMostUnfinished = 500;

/// Sums over all shapes.
struct RootTotals {
  std::uint64_t undecided = 0;
  std::uint64_t unfinished = 0;
  std::uint64_t zero_normals = 0;
};
inline RootTotals root_counts(const std::vector<Solid>& solids) {
  RootTotals totals;
  for (const Solid& solid : solids) {
    totals.undecided += solid.counts->undecided;
    totals.unfinished += solid.counts->unfinished;
    totals.zero_normals += solid.counts->zero_normals;
  }
  return totals;
}

}  // namespace orbs::tracer

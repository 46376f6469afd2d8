#pragma once

#include "scene/shapes/shape_type.h"

#include <numbers>
#include <vector>

/// Quadrics of revolution about y, and what all forms that turn have in common.
namespace orbs::scene {

/// x^2 + z^2 = a + b y + c y^2 from y_low to y_high, or for all y; caps are disks at both ends.
struct RevolvedQuadric {
  double a = 0;
  double b = 0;
  double c = 0;
  double y_low = 0;
  double y_high = 0;
  bool has_caps = false;
};

/// The member "caps" of forms that disks may close.
bool load_caps(ShapeEntry& entry);

inline LocalBox about_axis(double radius, double low, double high) {
  return {{-radius, low, -radius}, {radius, high, radius}};
}

/// Segments around the axis, and bands along curved profiles. The facets of quadrics and tori are within 8e-5
/// of the radius that they turn with.
constexpr int kShapeSegments = 256;
constexpr int kShapeBands = kShapeSegments / 2;

inline double turn_rad(int part) { return 2 * std::numbers::pi * part / kShapeSegments; }

/// A disk about the axis.
void add_cap(Mesh& mesh, double y, double radius, bool is_top);

/// The quadric as a mesh, with caps, cut at these heights from above to below.
Mesh turned(const RevolvedQuadric& quadric, const std::vector<double>& heights);
/// Cut into bands of one height.
Mesh turned(const RevolvedQuadric& quadric, int bands);

}  // namespace orbs::scene

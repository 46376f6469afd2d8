#include "scene/shapes/shape_bounds.h"

#include <algorithm>

namespace orbs::scene {

namespace {

struct Box {
  Vec3d low;
  Vec3d high;
};

Box about_axis(double radius, double low, double high) {
  return {{-radius, low, -radius}, {radius, high, radius}};
}

struct LocalBox {
  Box operator()(const SphereForm& f) const {
    const Vec3d r{f.radius_m, f.radius_m, f.radius_m};
    return {f.centre_m - r, f.centre_m + r};
  }
  Box operator()(const CylinderForm& f) const { return about_axis(f.radius_m, 0, f.height_m); }
  Box operator()(const ConeForm& f) const {
    return about_axis(std::max(f.radius_m, f.top_radius_m), 0, f.height_m);
  }
  Box operator()(const DiskForm& f) const { return about_axis(f.radius_m, 0, 0); }
  Box operator()(const ParaboloidForm& f) const { return about_axis(f.radius_m, 0, f.height_m); }
  Box operator()(const HyperboloidForm& f) const { return about_axis(f.radius_m, 0, f.height_m); }
  Box operator()(const BoxForm& f) const { return {-f.half_sizes_m, f.half_sizes_m}; }
  Box operator()(const HalfSpaceForm&) const { return {}; }  // has no end
  Box operator()(const TorusForm& f) const {
    return about_axis(f.major_radius_m + f.minor_radius_m, -f.minor_radius_m, f.minor_radius_m);
  }
  Box operator()(const SuperellipsoidForm&) const { return {{-1, -1, -1}, {1, 1, 1}}; }
  Box operator()(const ImplicitForm& f) const { return {f.low_m, f.high_m}; }
  // The plug-in knows, and only the tracer opens it: the point where the shape is placed stands for it.
  Box operator()(const PluginForm&) const { return {}; }
  Box operator()(const CsgForm&) const { return {}; }  // bounding_corners does not come here with CSG
};

void add_corners(const Shape& shape, const Mat4& around, std::vector<Vec3d>& corners) {
  const Mat4 matrix = around * shape.matrix;
  if (const auto* csg = std::get_if<CsgForm>(&shape.form)) {
    for (const Shape& operand : csg->operands) add_corners(operand, matrix, corners);
    return;
  }
  if (std::holds_alternative<HalfSpaceForm>(shape.form)) return;
  const Box box = std::visit(LocalBox{}, shape.form);
  for (const double x : {box.low.x, box.high.x})
    for (const double y : {box.low.y, box.high.y})
      for (const double z : {box.low.z, box.high.z}) corners.push_back(transform_point(matrix, {x, y, z}));
}

}  // namespace

std::vector<Vec3d> bounding_corners(const Shape& shape) {
  std::vector<Vec3d> corners;
  add_corners(shape, Mat4{}, corners);
  return corners;
}

}  // namespace orbs::scene

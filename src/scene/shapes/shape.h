#pragma once

#include "base/matrix.h"
#include "base/vec.h"
#include "scene/shapes/expression.h"

#include <map>
#include <string>
#include <variant>
#include <vector>

/// Surfaces by their formula. The axis of all that turn is y, and they begin at y = 0. A closed form has an
/// inside; its normals point out of it. Sizes are in metres before the matrix of the shape.
namespace orbs::scene {

struct SphereForm {
  Vec3d centre_m;
  double radius_m = 1;
  bool operator==(const SphereForm&) const = default;
};
/// x^2 + z^2 = radius^2 from y = 0 to height; `has_caps`: closed by disks.
struct CylinderForm {
  double radius_m = 1;
  double height_m = 1;
  bool has_caps = true;
  bool operator==(const CylinderForm&) const = default;
};
/// The radius falls evenly from `radius` at y = 0 to `top_radius` at the height.
struct ConeForm {
  double radius_m = 1;
  double top_radius_m = 0;
  double height_m = 1;
  bool has_caps = true;
  bool operator==(const ConeForm&) const = default;
};
/// y = 0, normal +y; it has no inside.
struct DiskForm {
  double radius_m = 1;
  bool operator==(const DiskForm&) const = default;
};
/// y = height (x^2 + z^2) / radius^2 up to the height.
struct ParaboloidForm {
  double radius_m = 1;
  double height_m = 1;
  bool has_caps = true;
  bool operator==(const ParaboloidForm&) const = default;
};
/// Of one sheet: `radius` at y = 0 and at the height, `waist_radius` half way.
struct HyperboloidForm {
  double radius_m = 1;
  double waist_radius_m = 0.5;
  double height_m = 1;
  bool has_caps = true;
  bool operator==(const HyperboloidForm&) const = default;
};
/// About the origin.
struct BoxForm {
  Vec3d half_sizes_m{1, 1, 1};
  bool operator==(const BoxForm&) const = default;
};
/// y < 0. It has no end, so that it stands only where another solid bounds it.
struct HalfSpaceForm {
  bool operator==(const HalfSpaceForm&) const = default;
};
/// The ring lies in the xz plane.
struct TorusForm {
  double major_radius_m = 1;
  double minor_radius_m = 0.25;
  bool operator==(const TorusForm&) const = default;
};
/// (|x|^(2/e) + |z|^(2/e))^(e/n) + |y|^(2/n) = 1 with e = east_west, n = north_south (Barr 1981,
/// Superquadrics and Angle-Preserving Transformations).
struct SuperellipsoidForm {
  double east_west = 1;
  double north_south = 1;
  bool operator==(const SuperellipsoidForm&) const = default;
};
/// f = 0 within a box; inside is f < 0. Closed: the solid f <= 0 is cut by the box, whose faces belong to it.
struct ImplicitForm {
  Expression expression;
  Vec3d low_m;
  Vec3d high_m;
  bool is_closed = false;
  bool operator==(const ImplicitForm&) const = default;
};

/// What a plug-in of the built-in tracer makes of these numbers (include/orbs/shape_plugin.h). The scene
/// holds no place where the plug-in lies, only its name: letters, digits, '-' and '_'. It has no inside.
struct PluginForm {
  std::string plugin;
  std::map<std::string, double> numbers;
  bool operator==(const PluginForm&) const = default;
};

enum class SetOperation { Union, Intersection, Difference };

struct Shape;

/// Constructive solid geometry, operand after operand: a - b - c is (a - b) - c. The operands are closed.
struct CsgForm {
  SetOperation operation = SetOperation::Union;
  std::vector<Shape> operands;  // two or more
  bool operator==(const CsgForm& other) const;
};

using ShapeForm = std::variant<SphereForm,
                               CylinderForm,
                               ConeForm,
                               DiskForm,
                               ParaboloidForm,
                               HyperboloidForm,
                               BoxForm,
                               HalfSpaceForm,
                               TorusForm,
                               SuperellipsoidForm,
                               ImplicitForm,
                               PluginForm,
                               CsgForm>;

struct Shape {
  std::string name;
  ShapeForm form;
  Mat4 matrix;
  int material = -1;  // -1 in an operand: that of the shape around it
  bool operator==(const Shape& other) const = default;
};

/// x^2 + z^2 = a + b y + c y^2 from y_low to y_high, or for all y; caps are disks at both ends.
struct RevolvedQuadric {
  double a = 0;
  double b = 0;
  double c = 0;
  double y_low = 0;
  double y_high = 0;
  bool has_caps = false;
};

/// The quadric of a cylinder, cone, paraboloid or hyperboloid.
RevolvedQuadric revolved(const CylinderForm& form);
RevolvedQuadric revolved(const ConeForm& form);
RevolvedQuadric revolved(const ParaboloidForm& form);
RevolvedQuadric revolved(const HyperboloidForm& form);

/// Tori and superellipsoids as implicit surfaces.
ImplicitForm implicit(const TorusForm& form);
ImplicitForm implicit(const SuperellipsoidForm& form);

/// "a cylinder", as messages say it.
const char* what_is(const ShapeForm& form);
/// The level that has this form: S1 quadrics and boxes, S2 tori and superellipsoids, S3 implicit surfaces, S4
/// solids by CSG, S7 shapes of plug-ins.
const char* level_of(const ShapeForm& form);
/// Whether the form has an inside.
bool is_closed(const ShapeForm& form);

/// Calls visit(shape, material) for the shape, or for each shape in it that is no CSG.
template <typename F>
void for_each_leaf(const Shape& shape, int material, const F& visit) {
  const int own = shape.material < 0 ? material : shape.material;
  if (const auto* csg = std::get_if<CsgForm>(&shape.form))
    for (const Shape& operand : csg->operands) for_each_leaf(operand, own, visit);
  else
    visit(shape, own);
}

}  // namespace orbs::scene

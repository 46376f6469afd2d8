#pragma once

#include "base/matrix.h"
#include "base/nth.h"
#include "scene/shapes/box.h"
#include "scene/shapes/cone.h"
#include "scene/shapes/cylinder.h"
#include "scene/shapes/disk.h"
#include "scene/shapes/half_space.h"
#include "scene/shapes/hyperboloid.h"
#include "scene/shapes/implicit.h"
#include "scene/shapes/paraboloid.h"
#include "scene/shapes/plugin.h"
#include "scene/shapes/sphere.h"
#include "scene/shapes/superellipsoid.h"
#include "scene/shapes/torus.h"

#include <array>
#include <string>
#include <variant>
#include <vector>

namespace orbs::scene {

enum class SetOperation { Union, Intersection, Difference };

struct Shape;

/// Constructive solid geometry, operand after operand: a - b - c is (a - b) - c. The operands are closed.
struct CsgForm {
  static constexpr std::array kTypes{"union", "intersection", "difference"};
  static constexpr const char* kWhat = "a solid by CSG";
  static constexpr const char* kLevel = "S4";
  SetOperation operation = SetOperation::Union;
  std::vector<Shape> operands;  // two or more
  bool operator==(const CsgForm& other) const;
};

inline const char* type_word(const CsgForm& form) { return nth(CsgForm::kTypes, form.operation); }

void load(ShapeEntry& entry, CsgForm& loaded);
void write(json::Writer& out, const MaterialList& materials, const CsgForm& form);
inline bool is_closed(const CsgForm&) { return true; }
/// Nothing: its operands have bounds, each under its own matrix (bounding_corners).
inline std::optional<LocalBox> bounds(const CsgForm&) { return std::nullopt; }
inline std::optional<Mesh> tessellated(const CsgForm&) { return std::nullopt; }

/// Whether the solid has an end. Those without one would fill space: a half-space, a union with one, what it
/// is taken from, and an intersection of nothing else.
bool is_bounded(const Shape& shape);

/// Variants of forms only, see ShapeType.
template <ShapeType... Types>
using ShapeVariant = std::variant<Types...>;

/// All forms, in the order in which messages list them.
using ShapeForm = ShapeVariant<SphereForm,
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

/// The word of the scene file for the form: "torus", "union".
const char* type_name(const ShapeForm& form);
/// "a cylinder", as messages say it.
const char* what_is(const ShapeForm& form);
/// The level that has this form: S1 quadrics and boxes, S2 tori and superellipsoids, S3 implicit surfaces, S4
/// solids by CSG, S7 shapes of plug-ins.
const char* level_of(const ShapeForm& form);

/// The functions of ShapeType, of any form.
bool is_closed(const ShapeForm& form);
std::optional<LocalBox> bounds(const ShapeForm& form);
std::optional<Mesh> tessellated(const ShapeForm& form);

/// One entry of "shapes". InputError at the key that is wrong.
Shape load_shape(json::ObjectReader& in, const Names& materials);
/// One of "operands": it may lack a material and an end.
Shape load_operand(ShapeEntry& entry);
/// Writes a shape as load_shape reads it.
void write_shape(json::Writer& out, const MaterialList& materials, const Shape& shape);

/// The corners of boxes that together hold the shape, in the world. Of solids by CSG those of all operands
/// that have an end: what is taken away as well.
std::vector<Vec3d> bounding_corners(const Shape& shape);

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

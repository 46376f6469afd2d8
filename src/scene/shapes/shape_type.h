#pragma once

#include "base/vec.h"
#include "scene/geometry/mesh.h"

#include <concepts>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace orbs::json {
class ObjectReader;
class Writer;
}  // namespace orbs::json

/// A form is a surface by its formula: a struct with `kType`, its word in the scene file, `kWhat`, as
/// messages say it, `kLevel`, the level that draws it, and the free functions of ShapeType beside it; all of
/// it is one header and one source file of this folder and a line in the variant ShapeForm (CSG, whose
/// operands are shapes again, stands beside the variant). A function that is missing is a compile error. The
/// axis of all that turn is y, and they begin at y = 0. A closed form has an inside; its normals point out of
/// it. Sizes are in metres before the matrix of the shape.
///
/// The built-in tracer and POV-Ray's exporter draw a form that has revolved(form) as a quadric (revolved.h)
/// and one that has implicit(form) as an implicit surface (implicit.h): such a form needs nothing else.
namespace orbs::scene {

class Names;
struct Material;
using MaterialList = std::vector<Material>;

/// How much one entry of "shapes" may still nest and hold.
struct SolidLimits {
  int depth = 0;
  std::size_t leaves = 0;
};

/// What a form is read from: its entry in the scene file, and what the names in it refer to.
struct ShapeEntry {
  json::ObjectReader& in;
  const Names& materials;
  SolidLimits& limits;
};

struct LocalBox {
  Vec3d low;
  Vec3d high;
};

/// load: reads the members of the form; InputError at the key that is wrong.
/// write: the members that load reads, so that reading them gives the same form.
/// is_closed: whether the form has an inside. `kClosedBy` says what would give it one, where something does.
/// bounds: around the form; nothing where it has no end.
/// tessellated: a mesh of the form with the normals and texture coordinates of the formula at its vertices,
/// which lie on the surface; nothing where a renderer without the level cannot draw it.
template <typename Form>
concept ShapeType = requires(
    ShapeEntry& entry, json::Writer& out, const MaterialList& materials, Form& loaded, const Form& form) {
  { Form::kWhat } -> std::convertible_to<std::string_view>;
  { Form::kLevel } -> std::convertible_to<std::string_view>;
  { load(entry, loaded) } -> std::same_as<void>;
  { write(out, materials, form) } -> std::same_as<void>;
  { is_closed(form) } -> std::same_as<bool>;
  { bounds(form) } -> std::same_as<std::optional<LocalBox>>;
  { tessellated(form) } -> std::same_as<std::optional<Mesh>>;
};

}  // namespace orbs::scene

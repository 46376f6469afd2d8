#include "adapters/povray/shapes.h"

#include "adapters/kind_support.h"
#include "adapters/povray/isosurface.h"
#include "adapters/povray/materials.h"
#include "adapters/povray/sdl.h"
#include "base/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <fmt/format.h>

namespace orbs::adapters::povray {

namespace {

using namespace scene;

// x^2 - c y^2 + z^2 - b y - a; the widest circle bounds it, so that rays elsewhere are not tried.
std::string quadric_text(const RevolvedQuadric& q) {
  double widest = 0;
  for (const double y : {q.y_low, q.y_high}) widest = std::max(widest, q.a + y * (q.b + y * q.c));
  const double r = std::sqrt(widest) * 1.001;
  const std::string quadric = fmt::format("quadric {{ <1,{},1>, <0,0,0>, <0,{},0>, {}", -q.c, -q.b, -q.a);
  if (!q.has_caps)
    return fmt::format("{} clipped_by {{ box {{ <{},{},{}>, <{},{},{}> }} }} bounded_by {{ clipped_by }}",
                       quadric, -r, q.y_low, -r, r, q.y_high, r);
  return fmt::format(
      "intersection {{ {} }} plane {{ <0,1,0>, {} }} plane {{ <0,-1,0>, {} }} bounded_by {{ box {{ <{},{},{}>, "
      "<{},{},{}> }} }}",
      quadric, q.y_high, -q.y_low, -r, q.y_low - 0.001 * r, -r, r, q.y_high + 0.001 * r, r);
}

// Forms that POV-Ray has a word of its own for.
struct OwnText {
  std::string operator()(const SphereForm& f) const {
    return fmt::format("sphere {{ {}, {}", vector(f.centre_m), f.radius_m);
  }
  std::string operator()(const DiskForm& f) const {
    return fmt::format("disc {{ <0,0,0>, <0,1,0>, {}", f.radius_m);
  }
  std::string operator()(const BoxForm& f) const {
    return fmt::format("box {{ {}, {}", vector(-f.half_sizes_m), vector(f.half_sizes_m));
  }
  std::string operator()(const HalfSpaceForm&) const { return "plane { <0,1,0>, 0"; }
  std::string operator()(const TorusForm& f) const {
    return fmt::format("torus {{ {}, {} sturm", f.major_radius_m, f.minor_radius_m);
  }
  // The axis of POV-Ray's is z.
  std::string operator()(const SuperellipsoidForm& f) const {
    return fmt::format("superellipsoid {{ <{},{}> matrix <1,0,0, 0,0,1, 0,1,0, 0,0,0>", f.east_west,
                       f.north_south);
  }
};

std::string csg_text(const CsgForm& form);

// All others are quadrics, isosurfaces and CSG; nothing for a form that is none of them.
std::optional<std::string> form_text(const ShapeForm& form, bool is_operand) {
  return std::visit(
      [&](const auto& f) -> std::optional<std::string> {
        if constexpr (WritesKind<OwnText, std::decay_t<decltype(f)>>)
          return OwnText{}(f);
        else if constexpr (requires { revolved(f); })
          return quadric_text(revolved(f));
        else if constexpr (requires { implicit(f); })
          return isosurface_text(implicit(f), is_operand);
        else if constexpr (requires { csg_text(f); })
          return csg_text(f);
        else
          return std::nullopt;
      },
      form);
}

std::string written(const ShapeForm& form, bool is_operand) {
  if (auto text = form_text(form, is_operand)) return *text;
  throw InputError(fmt::format("POV-Ray has no {}", type_name(form)));
}

// merge: a union would keep the faces inside.
std::string csg_text(const CsgForm& form) {
  constexpr std::array kWords{"merge", "intersection", "difference"};
  std::string text = fmt::format("{} {{", kWords[static_cast<std::size_t>(form.operation)]);
  for (const Shape& operand : form.operands) {
    text += fmt::format("\n  {}", written(operand.form, true));
    if (operand.material >= 0) text += fmt::format(" texture {{ Material{} }}", operand.material);
    text += fmt::format(" {} }}", matrix(operand.matrix));
  }
  return text;
}

// Why a leaf cannot be written; "" when it can, and when beyond_orbs_limits gives the reason.
std::string form_limit(const ShapeForm& form) {
  return std::visit(
      [&](const auto& f) -> std::string {
        using Form = std::decay_t<decltype(f)>;
        if constexpr (WritesKind<OwnText, Form> || requires { revolved(f); })
          return "";
        else if constexpr (requires { implicit(f); })
          return isosurface_limit(implicit(f));
        else
          return is_refused(Form::kLevel, beyond_orbs()) ? ""
                                                         : fmt::format("POV-Ray has no {}", type_name(form));
      },
      form);
}

}  // namespace

std::string open_shape_text(const Shape& shape) {
  return fmt::format("{} texture {{ Material{} }} {}", written(shape.form, false), shape.material,
                     matrix(shape.matrix));
}

std::optional<int> photon_material(const Scene& scene, const Shape& shape) {
  std::optional<int> found;
  for_each_leaf(shape, shape.material, [&](const Shape&, int material) {
    const auto surface = surface_of(material_at(scene, material).model);
    if (surface == Surface::Glass || (surface == Surface::Mirror && !found)) found = material;
  });
  return found;
}

std::string shape_limit(const Scene& scene, const Shape& shape, const std::string& display_name) {
  std::set<int> glasses;
  std::string problem;
  for_each_leaf(shape, shape.material, [&](const Shape& leaf, int index) {
    const Material& material = material_at(scene, index);
    if (texture_of(material.model))
      problem =
          fmt::format("{} has a texture: POV-Ray's shapes have different texture coordinates", display_name);
    if (surface_of(material.model) == Surface::Glass) glasses.insert(index);
    if (const auto reason = form_limit(leaf.form); !reason.empty())
      problem = fmt::format("{}: {}", display_name, reason);
  });
  if (glasses.size() > 1)
    return fmt::format("{} is made of several glasses: an object of POV-Ray has one interior", display_name);
  return problem;
}

}  // namespace orbs::adapters::povray

#include "adapters/povray/shapes.h"

#include "adapters/kind_support.h"
#include "adapters/povray/materials.h"
#include "adapters/povray/sdl.h"
#include "base/error.h"
#include "base/nth.h"
#include "scene/shapes/dual.h"
#include "scene/shapes/shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace orbs::adapters::povray {

namespace {

using namespace scene;

constexpr std::size_t kLongest = 50'000;  // characters of a function

std::string call(const char* name, const std::string& a, const std::string& b = "") {
  return fmt::format("{}({}{}{})", name, a, b.empty() ? "" : ",", b);
}

// One step written with the texts of those that it takes. Powers are pow(), since POV-Ray's ^ binds otherwise
// than ours before a sign; its log is decadic.
std::string step_text(const Step& step, const std::string& a, const std::string& b) {
  const auto infix = [&](char sign) { return fmt::format("({}{}{})", a, sign, b); };
  switch (step.operation) {
    case Operation::Constant:
      return fmt::format("({})", step.number);
    case Operation::X:
      return "x";
    case Operation::Y:
      return "y";
    case Operation::Z:
      return "z";
    case Operation::Add:
      return infix('+');
    case Operation::Subtract:
      return infix('-');
    case Operation::Multiply:
      return infix('*');
    case Operation::Divide:
      return infix('/');
    case Operation::Negate:
      return fmt::format("(-{})", a);
    case Operation::IntegerPower:
    case Operation::RealPower:
      return call("pow", a, fmt::format("{}", step.number));
    case Operation::Sin:
      return call("sin", a);
    case Operation::Cos:
      return call("cos", a);
    case Operation::Exp:
      return call("exp", a);
    case Operation::Log:
      return call("ln", a);
    case Operation::Sqrt:
      return call("sqrt", a);
    case Operation::Abs:
      return call("abs", a);
    case Operation::Min:
      return call("min", a, b);
    case Operation::Max:
      return call("max", a, b);
  }
  return "";
}

// "" when it would be longer than kLongest: functions have no names for parts, so that parts which are used
// several times are written several times.
std::string function_text(const Expression& expression) {
  std::vector<std::string> texts;
  for (const Step& step : expression.steps) {
    const auto text = [&](int i) { return i < 0 ? std::string() : nth(texts, i); };
    texts.push_back(step_text(step, text(step.a), text(step.b)));
    if (texts.back().size() > kLongest) return "";
  }
  return texts.back();
}

double largest(const Enclosure& a) { return std::max(-a.low, a.high); }

// A bound of |grad f| within a cell of the box.
double gradient_bound(const Expression& expression,
                      const Point<Enclosure>& cell,
                      std::vector<Slope>& values) {
  double squared = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto along = [&](const Enclosure& range, int own) {
      return Slope{range, Enclosure(own == axis ? 1 : 0)};
    };
    const Slope s =
        evaluate<Slope>(expression, {along(cell.x, 0), along(cell.y, 1), along(cell.z, 2)}, values);
    squared += largest(s.derivative) * largest(s.derivative);
  }
  return std::isnan(squared) ? std::numeric_limits<double>::infinity() : std::sqrt(squared);
}

struct BoundedCell {
  Point<Enclosure> cell;
  double bound = 0;
};

bool has_smaller_bound(const BoundedCell& a, const BoundedCell& b) { return a.bound < b.bound; }

std::array<Point<Enclosure>, 8> octants(const Point<Enclosure>& cell) {
  const auto half = [](const Enclosure& range, std::size_t upper) {
    const double middle = range.low + (range.high - range.low) / 2;
    return upper != 0 ? Enclosure(middle, range.high) : Enclosure(range.low, middle);
  };
  std::array<Point<Enclosure>, 8> parts;
  for (std::size_t i = 0; i < parts.size(); ++i)
    parts.at(i) = {half(cell.x, i & 1U), half(cell.y, i & 2U), half(cell.z, i & 4U)};
  return parts;
}

// |grad f| is at least this, as it is at the middle of the cell.
double gradient_at_middle(const Expression& expression,
                          const Point<Enclosure>& cell,
                          std::vector<Gradient>& values) {
  const auto middle = [](const Enclosure& range) { return range.low + (range.high - range.low) / 2; };
  const auto found = evaluate<Gradient>(
      expression, {{middle(cell.x), {1, 0, 0}}, {middle(cell.y), {0, 1, 0}}, {middle(cell.z), {0, 0, 1}}},
      values);
  const double size = length(found.derivative);
  return std::isfinite(size) ? size : 0;
}

// POV-Ray's search takes steps of |f| over this bound, so its time is proportional to it: the cell with the
// largest bound is cut until that is hardly above a gradient that f has. The bound of a grid of 16 x 16 x 16
// cells was half as large again for the Barth decic.
double gradient_bound(const ImplicitForm& form) {
  constexpr double kSlack = 1.1;
  constexpr int kMostCuts = 20'000;
  std::vector<Slope> values(form.expression.steps.size());
  std::vector<Gradient> points(form.expression.steps.size());
  const auto range = [](double low, double high) { return Enclosure(low, high); };
  const Point<Enclosure> box{range(form.low_m.x, form.high_m.x), range(form.low_m.y, form.high_m.y),
                             range(form.low_m.z, form.high_m.z)};
  std::vector<BoundedCell> cells{{box, gradient_bound(form.expression, box, values)}};
  double reached = 0;
  for (int i = 0; i < kMostCuts && cells.front().bound > kSlack * reached; ++i) {
    std::pop_heap(cells.begin(), cells.end(), has_smaller_bound);
    const Point<Enclosure> largest_cell = cells.back().cell;
    cells.pop_back();
    for (const auto& part : octants(largest_cell)) {
      cells.push_back({part, gradient_bound(form.expression, part, values)});
      std::push_heap(cells.begin(), cells.end(), has_smaller_bound);
      reached = std::max(reached, gradient_at_middle(form.expression, part, points));
    }
  }
  return cells.front().bound;
}

// The isosurface, without closing bracket. Its max_gradient, below which POV-Ray passes over roots, is a
// proven bound: that of interval arithmetic over cells of the box.
std::string isosurface_text(const ImplicitForm& form, bool is_operand) {
  const double size = length(form.high_m - form.low_m);
  return fmt::format(
      "isosurface {{ function {{ {} }} contained_by {{ box {{ {}, {} }} }} max_gradient {:.6g} accuracy {:.3g}{}{}",
      function_text(form.expression), vector(form.low_m), vector(form.high_m), gradient_bound(form),
      1e-6 * size, form.is_closed ? "" : " open", is_operand ? " all_intersections" : "");
}

// Why the surface cannot be written, "" when it can: formulas that are too long, gradients without bound.
std::string isosurface_limit(const ImplicitForm& form) {
  if (function_text(form.expression).empty())
    return fmt::format("its formula has more than {} characters as a function of POV-Ray", kLongest);
  if (!std::isfinite(gradient_bound(form)))
    return "its gradient has no bound within its box, and POV-Ray's isosurface needs one";
  return "";
}

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

// Forms that POV-Ray has its own word for.
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
  std::string text = fmt::format("{} {{", nth(kWords, form.operation));
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

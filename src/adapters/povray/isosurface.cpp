#include "adapters/povray/isosurface.h"

#include "adapters/povray/sdl.h"
#include "scene/shapes/dual.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
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
    const auto text = [&](int i) { return i < 0 ? std::string() : texts[static_cast<std::size_t>(i)]; };
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

}  // namespace

std::string isosurface_text(const ImplicitForm& form, bool is_operand) {
  const double size = length(form.high_m - form.low_m);
  return fmt::format(
      "isosurface {{ function {{ {} }} contained_by {{ box {{ {}, {} }} }} max_gradient {:.6g} accuracy {:.3g}{}{}",
      function_text(form.expression), vector(form.low_m), vector(form.high_m), gradient_bound(form),
      1e-6 * size, form.is_closed ? "" : " open", is_operand ? " all_intersections" : "");
}

std::string isosurface_limit(const ImplicitForm& form) {
  if (function_text(form.expression).empty())
    return fmt::format("its formula has more than {} characters as a function of POV-Ray", kLongest);
  if (!std::isfinite(gradient_bound(form)))
    return "its gradient has no bound within its box, and POV-Ray's isosurface needs one";
  return "";
}

}  // namespace orbs::adapters::povray

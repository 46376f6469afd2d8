#include "adapters/povray/isosurface.h"

#include "adapters/povray/sdl.h"
#include "scene/shapes/dual.h"

#include <algorithm>
#include <array>
#include <cmath>
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
  return std::sqrt(squared);
}

double gradient_bound(const ImplicitForm& form) {
  constexpr int kCells = 16;
  std::vector<Slope> values(form.expression.steps.size());
  const auto cell = [](double low, double high, int i) {
    const double step = (high - low) / kCells;
    return Enclosure(low + i * step, low + (i + 1) * step);
  };
  double bound = 0;
  for (int i = 0; i < kCells; ++i)
    for (int j = 0; j < kCells; ++j)
      for (int k = 0; k < kCells; ++k)
        bound = std::max(
            bound, gradient_bound(form.expression,
                                  {cell(form.low_m.x, form.high_m.x, i), cell(form.low_m.y, form.high_m.y, j),
                                   cell(form.low_m.z, form.high_m.z, k)},
                                  values));
  return bound;
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

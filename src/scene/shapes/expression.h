#pragma once

#include "base/nth.h"

#include <cmath>
#include <span>
#include <string>
#include <vector>

/// Formulas f(x, y, z) of implicit surfaces, and their values.

namespace orbs::scene {

enum class Operation {
  Constant,
  X,
  Y,
  Z,
  Add,
  Subtract,
  Multiply,
  Divide,
  Negate,
  IntegerPower,  // by `number`, a whole one
  RealPower,     // by `number`; unless it is whole there is no value where the base is negative
  Sin,
  Cos,
  Exp,
  Log,
  Sqrt,
  Abs,
  Min,
  Max
};

/// One step; `a` and `b` are the places of earlier steps whose values it takes, -1 where it takes none.
struct Step {
  Operation operation = Operation::Constant;
  int a = -1;
  int b = -1;
  double number = 0;  // of Constant; the exponent of powers
  bool operator==(const Step&) const = default;
};

/// A formula as it was written, and as steps of which the last one is the value. Equal parts are one step:
/// enclosures of x - x are as wide as twice x, those of one step used twice are computed once at least.
struct Expression {
  std::string text;
  std::vector<Step> steps;
  bool operator==(const Expression& other) const { return text == other.text; }
};

/// Reads +, -, *, /, ^ (with a constant exponent), numbers, x, y, z, pi, sin, cos, exp, log, sqrt, abs, min,
/// max and pow. Constant parts are computed in double. InputError with the column where the text is wrong,
/// and when it has more than 10000 characters or 1000 steps.
Expression parse_expression(const std::string& text);

/// To evaluate a formula, a kind of number, `N`, brings +, -, *, / and the functions below, found by argument
/// dependent lookup: double here, Enclosure in enclosure.h, values with derivatives in dual.h.
inline double integer_power(double a, int n) {
  double result = 1;
  for (int i = std::abs(n); i > 0; --i) result *= a;
  return n < 0 ? 1 / result : result;
}
inline double real_power(double a, double exponent) { return std::pow(a, exponent); }
inline double smaller(double a, double b) { return a < b ? a : b; }
inline double larger(double a, double b) { return a > b ? a : b; }
template <typename N>
N constant(double value) {
  return N(value);
}

/// One step of the values that it takes; X, Y and Z have none.
template <typename N>
N apply(const Step& step, const N& a, const N& b) {
  using std::abs, std::cos, std::exp, std::log, std::sin, std::sqrt;
  switch (step.operation) {
    case Operation::Add:
      return a + b;
    case Operation::Subtract:
      return a - b;
    case Operation::Multiply:
      return a * b;
    case Operation::Divide:
      return a / b;
    case Operation::Negate:
      return -a;
    case Operation::IntegerPower:
      return integer_power(a, static_cast<int>(step.number));
    case Operation::RealPower:
      return real_power(a, step.number);
    case Operation::Sin:
      return sin(a);
    case Operation::Cos:
      return cos(a);
    case Operation::Exp:
      return exp(a);
    case Operation::Log:
      return log(a);
    case Operation::Sqrt:
      return sqrt(a);
    case Operation::Abs:
      return abs(a);
    case Operation::Min:
      return smaller(a, b);
    case Operation::Max:
      return larger(a, b);
    case Operation::Constant:
    case Operation::X:
    case Operation::Y:
    case Operation::Z:
      break;
  }
  return constant<N>(step.number);
}

template <typename N>
struct Point {
  N x, y, z;
};

/// f(x, y, z); `values` is working memory, at least as long as the expression has steps.
template <typename N>
N evaluate(const Expression& expression, const Point<N>& p, std::span<N> values) {
  for (std::size_t i = 0; i < expression.steps.size(); ++i) {
    const Step& step = expression.steps[i];
    if (step.operation == Operation::X)
      values[i] = p.x;
    else if (step.operation == Operation::Y)
      values[i] = p.y;
    else if (step.operation == Operation::Z)
      values[i] = p.z;
    else
      values[i] = apply(step, nth(values, step.a < 0 ? 0 : step.a), nth(values, step.b < 0 ? 0 : step.b));
  }
  return values[expression.steps.size() - 1];
}

}  // namespace orbs::scene

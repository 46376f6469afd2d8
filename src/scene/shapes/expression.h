#pragma once

#include <string>
#include <vector>

/// Formulas f(x, y, z) of implicit surfaces.

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
  RealPower,     // by `number`; where the base is negative there is no value
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

}  // namespace orbs::scene

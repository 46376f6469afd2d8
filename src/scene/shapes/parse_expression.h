#pragma once

#include "scene/shapes/expression.h"

namespace orbs::scene {

/// Reads +, -, *, /, ^ (with a constant exponent), numbers, x, y, z, pi, sin, cos, exp, log, sqrt, abs, min,
/// max and pow. Constant parts are computed in double. InputError with the column where the text is wrong,
/// and when it has more than 10000 characters or 1000 steps.
Expression parse_expression(const std::string& text);

}  // namespace orbs::scene

#include "fuzz/feed.h"
#include "scene/shapes/dual.h"
#include "scene/shapes/enclosure.h"
#include "scene/shapes/expression.h"

#include <array>
#include <cmath>
#include <vector>

namespace orbs::fuzz {

namespace {

// The enclosure over a box holds the value at a point of it: each step rounds outwards by more than the same
// step of doubles is off by.
void check_enclosure(const scene::Expression& expression, const scene::Point<double>& p) {
  constexpr double kReach = 0.125;
  const auto around = [](double x) { return scene::Enclosure(x - kReach, x + kReach); };
  std::vector<double> numbers(expression.steps.size());
  std::vector<scene::Enclosure> enclosures(expression.steps.size());
  const double value = scene::evaluate<double>(expression, p, numbers);
  const auto enclosure =
      scene::evaluate<scene::Enclosure>(expression, {around(p.x), around(p.y), around(p.z)}, enclosures);
  for (const double number : numbers)
    if (!std::isfinite(number)) return;  // behind a pole or an overflow nothing is promised
  require(enclosure.low <= value && value <= enclosure.high, "an enclosure holds the value");
}

}  // namespace

std::string feed_expression(std::string_view bytes) {
  scene::Expression expression;
  try {
    expression = scene::parse_expression(std::string(bytes));
  } catch (const InputError& e) {
    return e.what();
  }
  require(!expression.steps.empty(), "a formula has a step");
  constexpr std::array kNumbers{-1e6, -2.5, -0.0, 0.0, 0.7, 3.0, 1e-9};
  for (const double x : kNumbers)
    for (const double y : kNumbers) check_enclosure(expression, {x, y, x - y});
  return "";
}

}  // namespace orbs::fuzz

// Enclosures hold what they enclose: values at random points of random boxes, of every step a formula may
// have.
#include "scene/shapes/dual.h"
#include "scene/shapes/expression.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

using namespace orbs::scene;

namespace {

const std::vector<std::string>& formulas() {
  static const std::vector<std::string> kFormulas{"x + y * z",
                                                  "x - y / (z^2 + 0.1)",
                                                  "x / y",
                                                  "x^2 * y^3 - z^5",
                                                  "x^-2 + y",
                                                  "pow(abs(x), 1.7) - y",
                                                  "abs(x)^0.4 + z",
                                                  "x^222 - y",
                                                  "x^201 - y^-202",
                                                  "sin(3 * x) * cos(7 * y)",
                                                  "sin(1 / x) + y",
                                                  "exp(x - y) - 2",
                                                  "log(x * x + 0.01) + y",
                                                  "log(x) - y",
                                                  "sqrt(x * x + y * y) - z",
                                                  "sqrt(x) - y",
                                                  "min(x, y) + z",
                                                  "max(x * y, z) - 0.3",
                                                  "abs(x - y) - abs(z)",
                                                  "-x^2 + y",
                                                  "(x^2 + y^2 + z^2 + 0.84)^2 - 4 * (x^2 + y^2)",
                                                  "cos(1e3 * x) - y"};
  return kFormulas;
}

struct Sides {
  double low, high;
  Enclosure enclosure() const { return {low, high}; }
};

Sides random_sides(std::mt19937& random) {
  std::uniform_real_distribution<double> even(-2, 2);
  std::uniform_int_distribution<int> exponent(0, 40);
  const double a = even(random);
  const double b = a + std::ldexp(even(random), -exponent(random));
  return {std::min(a, b), std::max(a, b)};
}

}  // namespace

TEST(Enclosure, HoldsTheValuesAndSlopesOfAllFormulas) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0, 1);
  for (const auto& text : formulas()) {
    const auto formula = parse_expression(text);
    std::vector<double> values(formula.steps.size());
    std::vector<Slope> slopes(formula.steps.size());
    std::vector<Gradient> gradients(formula.steps.size());
    for (int i = 0; i < 2000; ++i) {
      const Sides x = random_sides(random);
      const Sides y = random_sides(random);
      const Sides z = random_sides(random);
      const Slope s = evaluate<Slope>(
          formula,
          {{x.enclosure(), Enclosure(1)}, {y.enclosure(), Enclosure(0)}, {z.enclosure(), Enclosure(0)}},
          slopes);
      for (int k = 0; k < 4; ++k) {
        const auto inside = [&](const Sides& a) {
          return std::clamp(a.low + share(random) * (a.high - a.low), a.low, a.high);
        };
        const Point<double> p{inside(x), inside(y), inside(z)};
        const double value = evaluate<double>(formula, p, values);
        if (std::isnan(value)) continue;  // outside of where the formula has values
        ASSERT_LE(s.value.low, value) << text;
        ASSERT_GE(s.value.high, value) << text;
        const auto g =
            evaluate<Gradient>(formula, {{p.x, {1, 0, 0}}, {p.y, {0, 1, 0}}, {p.z, {0, 0, 1}}}, gradients);
        if (std::isnan(g.derivative.x)) continue;
        // The derivative at the point is rounded, its enclosure is not.
        const double rounding = 1e-12 * std::max(1.0, std::abs(g.derivative.x));
        ASSERT_LE(s.derivative.low, g.derivative.x + rounding) << text;
        ASSERT_GE(s.derivative.high, g.derivative.x - rounding) << text;
      }
    }
  }
}

TEST(Enclosure, OfSmallBoxesIsTight) {
  const auto formula = parse_expression("(x^2 + y^2 + z^2 + 0.84)^2 - 4 * (x^2 + y^2)");
  std::vector<Enclosure> values(formula.steps.size());
  const Enclosure at = evaluate<Enclosure>(formula, {Enclosure(0.3), Enclosure(0.7), Enclosure(0.2)}, values);
  EXPECT_GT(at.high - at.low, 0);
  EXPECT_LT(at.high - at.low, 1e-14);
}

TEST(Enclosure, OutsideOfWhereAFunctionHasValuesThereAreNone) {
  EXPECT_TRUE(is_empty(sqrt(Enclosure(-2, -1))));
  EXPECT_TRUE(is_empty(log(Enclosure(-2, -1)) + Enclosure(0, 1)));
  EXPECT_TRUE(is_empty(Enclosure(1, 2) * real_power(Enclosure(-2, -1), 0.5)));
  EXPECT_FALSE(holds_zero(sqrt(Enclosure(-2, -1)) - Enclosure(3, 4)));
}

TEST(Enclosure, OverflowKeepsFiniteEnds) {
  const Enclosure huge = Enclosure(1e200) * Enclosure(1e200);
  EXPECT_LT(huge.low, INFINITY);
  EXPECT_EQ(huge.high, INFINITY);
  EXPECT_FALSE(is_empty(huge - huge));
}

#include "property/chi_square.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace orbs::tests {

namespace {

// Abscissae and weights of the Gauss-Legendre rule with four points on [-1, 1].
constexpr std::array kAbscissae{-0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
                                0.8611363115940526};
constexpr std::array kWeights{0.3478548451374538, 0.6521451548625461, 0.6521451548625461, 0.3478548451374538};

double rule(const Cell& cell, const Density& density) {
  const Vec2d centre{(cell.low.x + cell.high.x) / 2, (cell.low.y + cell.high.y) / 2};
  const Vec2d half{(cell.high.x - cell.low.x) / 2, (cell.high.y - cell.low.y) / 2};
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      sum += kWeights[i] * kWeights[j] *
             density({centre.x + half.x * kAbscissae[i], centre.y + half.y * kAbscissae[j]});
  return sum * half.x * half.y;
}

std::array<Cell, 4> quarters(const Cell& c) {
  const Vec2d m{(c.low.x + c.high.x) / 2, (c.low.y + c.high.y) / 2};
  return {Cell{c.low, m}, Cell{{m.x, c.low.y}, {c.high.x, m.y}}, Cell{{c.low.x, m.y}, {m.x, c.high.y}},
          Cell{m, c.high}};
}

// Three levels are always divided, so that no narrow part of the density is stepped over.
double refined(const Cell& cell, const Density& density, double coarse, double tolerance, int level) {
  constexpr int kFewestLevels = 3;
  constexpr int kMostLevels = 11;
  std::array<double, 4> parts{};
  const auto cells = quarters(cell);
  double fine = 0;
  for (std::size_t i = 0; i < 4; ++i) fine += parts[i] = rule(cells[i], density);
  if (level >= kMostLevels || (level >= kFewestLevels && std::abs(fine - coarse) < tolerance)) return fine;
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) sum += refined(cells[i], density, parts[i], tolerance / 2, level + 1);
  return sum;
}

void halve(std::vector<Vec2d>::iterator begin,
           std::vector<Vec2d>::iterator end,
           const Cell& cell,
           int halvings,
           std::vector<Cell>& out) {
  if (halvings == 0 || end - begin < 2) {
    out.push_back(cell);
    return;
  }
  const auto middle = begin + (end - begin) / 2;
  const bool by_x = halvings % 2 == 0;
  std::nth_element(begin, middle, end, [&](Vec2d a, Vec2d b) { return by_x ? a.x < b.x : a.y < b.y; });
  Cell first = cell;
  Cell second = cell;
  (by_x ? first.high.x : first.high.y) = by_x ? middle->x : middle->y;
  (by_x ? second.low.x : second.low.y) = by_x ? middle->x : middle->y;
  halve(begin, middle, first, halvings - 1, out);
  halve(middle, end, second, halvings - 1, out);
}

bool holds(const Cell& c, Vec2d p) {
  return p.x >= c.low.x && p.x < c.high.x && p.y >= c.low.y && p.y < c.high.y;
}

double p_value_of(double statistic, int degrees) {
  if (degrees < 1) return statistic > 0 ? 0 : 1;  // nothing was to be expected
  const double spread = 2.0 / (9.0 * degrees);
  const double z = (std::cbrt(statistic / degrees) - (1 - spread)) / std::sqrt(spread);
  return 0.5 * std::erfc(z / std::sqrt(2.0));
}

}  // namespace

std::vector<Cell> cells_of(std::vector<Vec2d> points, Cell domain, int halvings) {
  std::vector<Cell> cells;
  halve(points.begin(), points.end(), domain, halvings, cells);
  return cells;
}

double integral_over(const Cell& cell, const Density& density, double tolerance) {
  return refined(cell, density, rule(cell, density), tolerance, 0);
}

ChiSquare chi_square(const std::vector<Vec2d>& points,
                     std::size_t trials,
                     const Cell& domain,
                     const Density& density) {
  constexpr int kHalvings = 5;
  std::vector<Vec2d> first;
  std::vector<Vec2d> second;
  for (std::size_t i = 0; i < points.size(); ++i) (i % 2 == 0 ? first : second).push_back(points[i]);
  const double half_trials = static_cast<double>(trials) / 2;
  ChiSquare out;
  out.accepted = static_cast<double>(points.size()) / static_cast<double>(trials);
  double tested = 0;
  for (const Cell& cell : cells_of(first, domain, kHalvings)) {
    const auto count = static_cast<double>(
        std::count_if(second.begin(), second.end(), [&](Vec2d p) { return holds(cell, p); }));
    const double probability = integral_over(cell, density, 1e-5);
    out.integral += probability;
    const double expected = probability * half_trials;
    tested += count;
    if (!(expected > 0)) {
      out.statistic += count > 0 ? INFINITY : 0;
      continue;
    }
    out.statistic += (count - expected) * (count - expected) / expected;
    ++out.degrees;
  }
  // The trials without a point are a cell of their own, unless there is next to none to expect.
  const double expected_rest = (1 - out.integral) * half_trials;
  const double rest = half_trials - tested;
  constexpr double kFewest = 20;
  if (expected_rest > kFewest) {
    out.statistic += (rest - expected_rest) * (rest - expected_rest) / expected_rest;
  } else {
    --out.degrees;
  }
  out.p_value = p_value_of(out.statistic, out.degrees);
  return out;
}

ChiSquare chi_square_of_counts(const std::vector<std::size_t>& counts,
                               const std::vector<double>& probabilities,
                               std::size_t trials) {
  constexpr double kFewest = 20;
  ChiSquare out;
  double rest = static_cast<double>(trials);
  double expected_rest = rest;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double expected = probabilities[i] * static_cast<double>(trials);
    const auto count = static_cast<double>(counts[i]);
    out.integral += probabilities[i];
    out.accepted += count / static_cast<double>(trials);
    if (expected == 0 && count > 0) out.statistic = INFINITY;
    if (expected < kFewest) continue;
    out.statistic += (count - expected) * (count - expected) / expected;
    ++out.degrees;
    rest -= count;
    expected_rest -= expected;
  }
  if (expected_rest > kFewest) {
    out.statistic += (rest - expected_rest) * (rest - expected_rest) / expected_rest;
  } else {
    // What is too rare for the statistic has a bound of its own. By Poisson's law right code exceeds it with
    // a probability below 1e-20.
    if (rest > expected_rest + 3 * kFewest) out.statistic = INFINITY;
    --out.degrees;
  }
  out.p_value = p_value_of(out.statistic, out.degrees);
  return out;
}

}  // namespace orbs::tests

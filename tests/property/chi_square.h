#pragma once

#include "base/vec.h"

#include <functional>
#include <vector>

/// Pearson's test of sampled points of a plane against their density, in cells of about equal probability.
namespace orbs::tests {

/// A rectangle [low, high) of the plane.
struct Cell {
  Vec2d low;
  Vec2d high;
};

using Density = std::function<double(Vec2d)>;

/// Cells of the domain that hold about as many of the points each, by halving at medians (a k-d tree);
/// `halvings` times, so that there are 2^halvings cells.
std::vector<Cell> cells_of(std::vector<Vec2d> points, Cell domain, int halvings);

/// Integral of a density over the cell by adaptive Gauss-Legendre quadrature, to about this absolute error.
double integral_over(const Cell& cell, const Density& density, double tolerance);

struct ChiSquare {
  double statistic = 0;
  int degrees = 0;
  double p_value = 1;   // of the statistic, by the approximation of Wilson and Hilferty 1931
  double integral = 0;  // of the density over the domain
  double accepted = 0;  // share of the trials that gave a point
};

/// `points` came of `trials` trials, which give no point with the probability that the density leaves. The
/// cells are made from every other point and tested with the rest, so that the counts are independent of
/// the cells.
ChiSquare chi_square(const std::vector<Vec2d>& points,
                     std::size_t trials,
                     const Cell& domain,
                     const Density& density);

/// The same of outcomes that can be told apart, such as picks from a list: how often each came of the trials.
/// Those of which fewer than 20 are to be expected count as one.
ChiSquare chi_square_of_counts(const std::vector<std::size_t>& counts,
                               const std::vector<double>& probabilities,
                               std::size_t trials);

}  // namespace orbs::tests

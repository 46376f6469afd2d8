#include "studies/cost/error_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace orbs::studies {

namespace {

// The parameters: bias^2, the logarithm of the variance at `scale_seconds`, and the exponent. Times are
// relative to the geometric mean of the points', where the two last ones are least correlated.
using Parameters = std::array<double, 3>;
using Matrix = std::array<std::array<double, 3>, 3>;

struct Model {
  std::vector<double> log_times;
  std::vector<double> errors;
  std::vector<double> weights;
};

double value_at(const Parameters& p, double log_time) { return p[0] + std::exp(p[1] - p[2] * log_time); }

Parameters slope_at(const Parameters& p, double log_time) {
  const double variable = std::exp(p[1] - p[2] * log_time);
  return {1, variable, -variable * log_time};
}

double chi_squared(const Model& model, const Parameters& p) {
  double sum = 0;
  for (std::size_t i = 0; i < model.errors.size(); ++i) {
    const double left = model.errors[i] - value_at(p, model.log_times[i]);
    sum += model.weights[i] * left * left;
  }
  return sum;
}

Matrix normal_matrix(const Model& model, const Parameters& p, Parameters& gradient) {
  Matrix normal{};
  gradient = {};
  for (std::size_t i = 0; i < model.errors.size(); ++i) {
    const auto slope = slope_at(p, model.log_times[i]);
    const double left = model.errors[i] - value_at(p, model.log_times[i]);
    for (std::size_t a = 0; a < 3; ++a) {
      gradient.at(a) += model.weights[i] * slope.at(a) * left;
      for (std::size_t b = 0; b < 3; ++b) normal.at(a).at(b) += model.weights[i] * slope.at(a) * slope.at(b);
    }
  }
  return normal;
}

double cofactor(const Matrix& m, std::size_t row, std::size_t column) {
  const auto at = [&](std::size_t i, std::size_t j) { return m.at((row + i) % 3).at((column + j) % 3); };
  return at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1);
}

// The parameters differ by many orders of magnitude, so the matrix is scaled to a diagonal of ones before it
// is inverted.
std::optional<Matrix> inverse(const Matrix& m) {
  Matrix scaled{};
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b) {
      if (!(m.at(a).at(a) > 0)) return std::nullopt;
      scaled.at(a).at(b) = m.at(a).at(b) / std::sqrt(m.at(a).at(a) * m.at(b).at(b));
    }
  double determinant = 0;
  for (std::size_t b = 0; b < 3; ++b) determinant += scaled.at(0).at(b) * cofactor(scaled, 0, b);
  constexpr double kSingular = 1e-12;
  if (!(determinant > kSingular)) return std::nullopt;
  Matrix out{};
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b)
      out.at(a).at(b) = cofactor(scaled, b, a) / determinant / std::sqrt(m.at(a).at(a) * m.at(b).at(b));
  return out;
}

Parameters solved(const Matrix& inverted, const Parameters& gradient) {
  Parameters step{};
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b) step.at(a) += inverted.at(a).at(b) * gradient.at(b);
  return step;
}

// Levenberg 1944, Marquardt 1963: steps of Gauss and Newton, damped until they improve the fit.
bool minimise(const Model& model, Parameters& p) {
  constexpr int kMostSteps = 200;
  constexpr double kConverged = 1e-10;
  constexpr double kLeastDamping = 1e-9;
  constexpr double kMostDamping = 1e9;
  double damping = 1e-3;
  double best = chi_squared(model, p);
  for (int step = 0; step < kMostSteps; ++step) {
    Parameters gradient{};
    auto damped = normal_matrix(model, p, gradient);
    for (std::size_t a = 0; a < 3; ++a) damped.at(a).at(a) *= 1 + damping;
    const auto inverted = inverse(damped);
    if (!inverted) {
      damping *= 10;
      continue;
    }
    const auto change = solved(*inverted, gradient);
    Parameters next{p[0] + change[0], p[1] + change[1], p[2] + change[2]};
    const double found = chi_squared(model, next);
    if (found < best - kConverged * (1 + best)) {
      p = next;
      best = found;
      damping = std::max(damping / 10, kLeastDamping);
      continue;
    }
    if (damping > kMostDamping) return true;  // no step, however short, improves it
    damping *= 10;
  }
  return false;
}

// A line through the logarithms of the first and the last positive error, without bias.
std::optional<Parameters> first_guess(const Model& model) {
  std::size_t first = model.errors.size();
  std::size_t last = first;
  for (std::size_t i = 0; i < model.errors.size(); ++i) {
    if (!(model.errors[i] > 0)) continue;
    if (first == model.errors.size()) first = i;
    last = i;
  }
  if (first == last) return std::nullopt;
  const double run = model.log_times[last] - model.log_times[first];
  if (!(run > 0)) return std::nullopt;
  const double exponent = std::clamp(-std::log(model.errors[last] / model.errors[first]) / run, 0.2, 3.0);
  return Parameters{0, std::log(model.errors[first]) + exponent * model.log_times[first], exponent};
}

void set_weights(Model& model, const std::vector<FitPoint>& points, const Parameters& p) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double raw = value_at(p, model.log_times[i]) + points[i].reference_noise;
    model.weights[i] = 1 / (points[i].relative_variance * raw * raw);
  }
}

// The F test of the misfit with d1 and d2 degrees of freedom, by Paulson's cube root approximation (Annals of
// Mathematical Statistics 13, 1942), which is good to a few per cent of the quantile.
double f_quantile_1_percent(double d1, double d2) {
  constexpr double kNormal = 2.326;
  const double a = 2 / (9 * d1);
  const double b = 2 / (9 * d2);
  const double denominator = (1 - b) * (1 - b) - kNormal * kNormal * b;
  if (!(denominator > 0)) return 1e9;  // too few degrees to refute anything
  const double root = ((1 - a) * (1 - b) + kNormal * std::sqrt((1 - b) * (1 - b) * a + (1 - a) * (1 - a) * b -
                                                               a * b * kNormal * kNormal)) /
                      denominator;
  return root * root * root;
}

}  // namespace

std::optional<ErrorFit> fit_error(const std::vector<FitPoint>& points, double degrees) {
  if (points.size() < 4) return std::nullopt;
  Model model;
  double centre = 0;
  for (const auto& point : points) centre += std::log(point.seconds) / static_cast<double>(points.size());
  for (const auto& point : points) {
    model.log_times.push_back(std::log(point.seconds) - centre);
    model.errors.push_back(point.error);
    const double raw = point.error + point.reference_noise;
    model.weights.push_back(1 / (point.relative_variance * raw * raw));
  }
  const auto guess = first_guess(model);
  if (!guess) return std::nullopt;
  Parameters p = *guess;
  constexpr int kReweightings = 5;  // more change no digit that is shown
  for (int i = 0; i < kReweightings; ++i) {
    if (!minimise(model, p)) return std::nullopt;
    set_weights(model, points, p);
  }
  Parameters gradient{};
  auto covariance = inverse(normal_matrix(model, p, gradient));
  if (!covariance) return std::nullopt;
  ErrorFit fit;
  const double left = static_cast<double>(points.size()) - 3;
  fit.misfit = chi_squared(model, p) / left;
  const double widened = fit.misfit > f_quantile_1_percent(left, degrees) ? fit.misfit : 1.0;
  const auto error_of = [&](std::size_t i) { return std::sqrt(widened * covariance->at(i).at(i)); };
  fit.bias_squared = student_interval(p[0], error_of(0), degrees, kOutside);
  fit.exponent = student_interval(p[2], error_of(2), degrees, kOutside);
  // log(variance after one second) = p1 + p2 centre.
  const double log_variance = p[1] + p[2] * centre;
  const double log_error =
      std::sqrt(widened * (covariance->at(1).at(1) + 2 * centre * covariance->at(1).at(2) +
                           centre * centre * covariance->at(2).at(2)));
  const auto logs = student_interval(log_variance, log_error, degrees, kOutside);
  fit.variance = {std::exp(logs.value), std::exp(logs.low), std::exp(logs.high)};
  constexpr double kFloorLevel = 0.001;
  fit.has_floor = widened <= 1 && student_interval(p[0], error_of(0), degrees, 2 * kFloorLevel).low > 0;
  return fit;
}

}  // namespace orbs::studies

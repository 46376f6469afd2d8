#pragma once

#include "json/fields.h"
#include "studies/seed_statistics.h"

#include <optional>
#include <string>
#include <vector>

namespace orbs::studies {

/// What is known of the error of one point.
struct FitPoint {
  double seconds = 0;            // above 0, without the fixed cost
  double error = 0;              // mean over the seeds, the reference's noise subtracted; it may be negative
  double reference_noise = 0;    // what was subtracted
  double relative_variance = 0;  // of the mean before that, over its square; above 0
};

/// error(t) = bias_squared + variance / t^exponent. Without bias and with independent samples the exponent
/// is 1; of stratified and low-discrepancy samples it is larger.
struct ErrorFit {
  Interval bias_squared;  // may be negative, as what was measured is noisy
  Interval variance;      // the error after one second, above the bias
  Interval exponent;
  double misfit = 0;             // chi^2 per degree of freedom, about 1 where the model holds
  bool has_floor = false;        // the model holds, and the bias differs from zero at a level of 1 in 1000
  std::string floor_named = {};  // what the gates of the case say of an image at the floor
};

template <class Visitor, json::RecordOf<ErrorFit> Record>
void fields(Visitor& visit, Record& fit) {
  visit("bias_squared", fit.bias_squared);
  visit("variance", fit.variance);
  visit("exponent", fit.exponent);
  visit("misfit", fit.misfit);
  visit("has_floor", fit.has_floor);
  visit("floor_named", fit.floor_named);
}

/// Least squares by Levenberg-Marquardt, weighted by the variances that the points have if the curve is
/// right: weights by the points' own errors would favour those that came out too small. `degrees` are those
/// with which the relative variances are known. The intervals are those of the linearised model; where the
/// points lie farther from the curve than their variances allow (F test, 1 in 100), they are widened by the
/// misfit. Nothing for fewer than four points, or when no curve is found.
std::optional<ErrorFit> fit_error(const std::vector<FitPoint>& points, double degrees);

}  // namespace orbs::studies

#pragma once

namespace orbs {

/// The probability that a variable of Student's distribution with `degrees` of freedom (above 0, not
/// necessarily whole) is farther from zero than |t|. It is 1 for t = 0 and 0 for infinity.
double student_tail(double t, double degrees);

/// The t > 0 whose student_tail is `probability`, in (0, 1).
double student_quantile(double probability, double degrees);

/// A number and the ends of an interval around it; what the interval means, its user says.
struct Interval {
  double value = 0;
  double low = 0;
  double high = 0;
};

/// value +- the reach of Student's distribution: `error` is the standard error of the value, `degrees` (at
/// least 1 are taken) are those with which it is known, and the interval misses with the probability
/// `outside`.
Interval student_interval(double value, double error, double degrees, double outside);

}  // namespace orbs

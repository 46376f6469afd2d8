#pragma once

namespace orbs {

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

#pragma once

namespace orbs {

/// The probability that a variable of Student's distribution with `degrees` of freedom (above 0, not
/// necessarily whole) is farther from zero than |t|. It is 1 for t = 0 and 0 for infinity.
double student_tail(double t, double degrees);

/// The t > 0 whose student_tail is `probability`, in (0, 1).
double student_quantile(double probability, double degrees);

}  // namespace orbs

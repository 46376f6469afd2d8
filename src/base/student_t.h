#pragma once

namespace orbs {

/// Probability that a variable of Student's distribution with `degrees` of freedom (above 0, not necessarily
/// whole) is farther from zero than |t|. 1 for 0, 0 for infinity.
double student_tail(double t, double degrees);

/// The t > 0 whose student_tail is `probability`, in (0, 1).
double student_quantile(double probability, double degrees);

}  // namespace orbs

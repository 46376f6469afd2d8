#pragma once

namespace orbs::adapters {

/// Smith's masking-shadowing of GGX is written as a product of two sides, 1 / ((1 + Lo)(1 + Li)), or
/// height-correlated, 1 / (1 + Lo + Li) (Heitz 2014, eq. 99), L = (sqrt(1 + alpha^2 tan^2) - 1) / 2. A
/// renderer with one form draws a material of the other darker or brighter by the ratio of both minus 1,
/// which this returns for both directions at 80 degrees from the normal; from beyond them comes 3 % (cos^2)
/// of the light that a surface gets from an even surrounding.
double masking_difference(double alpha);

/// The largest masking_difference that an exporter accepts for the same material. It is reached at alpha
/// 0.12; at 45 degrees that alpha makes a difference of 1.3e-5.
constexpr double kMostMaskingDifference = 0.01;

}  // namespace orbs::adapters

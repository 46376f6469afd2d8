#pragma once

#include "registry/case.h"

namespace orbs::registry {

/// The case for images whose width and height are divided by `divisor`: each of their pixels is the mean of
/// divisor x divisor px of the full size. A masked rectangle grows to every reduced pixel that it touches,
/// because part of what these show is masked. The region of a pixel check shrinks to the reduced pixels that
/// lie in it as a whole; where there is none, the check keeps its region, and not_measured says so.
Case reduced_case(Case one_case, int divisor);

}  // namespace orbs::registry

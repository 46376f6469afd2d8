#pragma once

#include "base/vec.h"

namespace orbs::spectra {

struct Lab {
  double l = 0;
  double a = 0;
  double b = 0;
};

/// CIE 1976 L*a*b* relative to a white (CIE 15:2004, section 8.2.1).
Lab lab_of(Vec3d xyz, Vec3d white_xyz);

/// CIEDE2000 with kL = kC = kH = 1: about 1 where a difference begins to be seen. Sharma, Wu and Dalal 2005,
/// "The CIEDE2000 Color-Difference Formula: Implementation Notes, Supplementary Test Data, and Mathematical
/// Observations"; the numbers in the code are the equations' there.
double ciede2000(Lab first, Lab second);

}  // namespace orbs::spectra

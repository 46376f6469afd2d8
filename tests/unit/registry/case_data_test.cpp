// What the cases that are shipped ask of every renderer.
#include "image/reduced_precision.h"
#include "registry/cases.h"
#include "registry/configuration.h"

#include <cmath>

#include <gtest/gtest.h>

using namespace orbs;

// A half float is linear light too, and POV-Ray writes nothing else. Subnormal values are far below any
// tolerance.
TEST(PixelChecks, AdmitImagesOfHalfFloats) {
  constexpr unsigned kSignificantBits = 11;
  int values = 0;
  for (const auto& suite : registry::load_configuration(ORBS_SOURCE_DIR "/configuration.json").suites)
    for (const auto& one_case : registry::load_cases(suite))
      for (const auto& check : one_case.pixel_checks)
        for (const double value : check.expected) {
          const auto rounded = image::rounded_to_bits(static_cast<float>(value), kSignificantBits);
          EXPECT_LE(std::abs(static_cast<double>(rounded) - value), check.tolerance)
              << one_case.name << ": " << check.why;
          ++values;
        }
  EXPECT_GT(values, 0);
}

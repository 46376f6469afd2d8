#pragma once

#include "tracer/sampling/sampler.h"

#include <cstdint>

namespace orbs::tracer {

/// One camera sample.
struct Sample {
  int x = 0;  // pixel of the camera
  int y = 0;
  SampleBlock block;
  std::uint32_t index = 0;  // within the block
  std::uint32_t pixel = 0;  // of the film
};

}  // namespace orbs::tracer

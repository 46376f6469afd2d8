#include "judge/exact_copy.h"

#include <algorithm>
#include <cmath>

namespace orbs::judge {

namespace {

bool has_no_noise(const metrics::PairSamples& samples) {
  return std::all_of(samples.reference_variance.begin(), samples.reference_variance.end(),
                     [](float variance) { return variance == 0; });
}

// Whether the reference changes from one neighbour over the pixel to the other one, along x or y: it does
// within the pixel, too. At an edge between two pixels it changes to one side alone.
bool varies_at(const metrics::PairSamples& samples, int x, int y, std::size_t channel) {
  const auto value = [&](int u, int v) { return samples.reference[3 * samples.pixel_at(u, v) + channel]; };
  const float here = value(x, y);
  const bool along_x = x > 0 && x + 1 < samples.width && here != value(x - 1, y) && here != value(x + 1, y);
  const bool along_y = y > 0 && y + 1 < samples.height && here != value(x, y - 1) && here != value(x, y + 1);
  return along_x || along_y;
}

}  // namespace

bool is_copy_of_exact_reference(const metrics::PairSamples& samples) {
  constexpr double kUnits = 0x1p-22;  // rounding to half floats is a thousand times as much
  if (samples.noise_source == metrics::NoiseSource::Reference || !has_no_noise(samples)) return false;
  std::size_t varying = 0;
  for (int y = 0; y < samples.height; ++y)
    for (int x = 0; x < samples.width; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t i = 3 * samples.pixel_at(x, y) + c;
        if (samples.included[i / 3] == 0) continue;
        if (std::fabs(samples.difference(i)) > kUnits * std::fabs(static_cast<double>(samples.reference[i])))
          return false;
        varying += varies_at(samples, x, y, c) ? 1 : 0;
      }
  return varying >= kFewestVarying;
}

}  // namespace orbs::judge

#include "judge/exact_copy.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace orbs::judge {

namespace {

bool has_no_noise(const metrics::PairSamples& samples) {
  return std::all_of(samples.reference_variance.begin(), samples.reference_variance.end(),
                     [](float variance) { return variance == 0; });
}

std::size_t different_values(std::vector<float> values) {
  std::sort(values.begin(), values.end());
  return static_cast<std::size_t>(std::unique(values.begin(), values.end()) - values.begin());
}

}  // namespace

bool is_copy_of_exact_reference(const metrics::PairSamples& samples) {
  constexpr double kUnits = 0x1p-22;  // rounding to half floats is a thousand times as much
  if (samples.noise_source == metrics::NoiseSource::Reference || !has_no_noise(samples)) return false;
  std::vector<float> values;
  for (std::size_t i = 0; i < samples.reference.size(); ++i) {
    if (samples.included[i / 3] == 0) continue;
    if (std::fabs(samples.difference(i)) > kUnits * std::fabs(static_cast<double>(samples.reference[i])))
      return false;
    values.push_back(samples.reference[i]);
  }
  return different_values(std::move(values)) >= kFewestValues;
}

}  // namespace orbs::judge

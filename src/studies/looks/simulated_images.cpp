#include "studies/looks/simulated_images.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace orbs::studies {

namespace {

constexpr double kBrightShare = 0.03;
constexpr double kBrightOdds = 50000;
constexpr int kRepeat_px = 8;

struct Sum {
  double value = 0;
  double square = 0;
};

// The sum of n samples and of their squares, in units of their mean: n exponential numbers sum to a gamma
// one, and the variance of their mean is stated as a renderer would, from the squares.
Sum sum_of_samples(const SampleLaw& law, int n, Random& random) {
  const double share = law.has_fireflies ? 1 - kBrightShare : 1;
  std::gamma_distribution<double> gamma(n, 1);
  const double plain = share * gamma(random);
  Sum sum{plain, 2 * plain * plain / n};  // the square of an exponential number is twice that of its mean
  if (!law.has_fireflies) return sum;
  std::poisson_distribution<int> count(n / kBrightOdds);
  const double bright = kBrightShare * kBrightOdds;
  const int met = count(random);
  sum.value += met * bright;
  sum.square += met * bright * bright;
  return sum;
}

image::Image with_own_noise(const Values& values, const SampleLaw& law, int n, Random& random) {
  auto out = image::make_image(kSimulatedSide_px, kSimulatedSide_px,
                               {"R", "G", "B", "variance.R", "variance.G", "variance.B"});
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Sum sum = sum_of_samples(law, n, random);
    const double mean = sum.value / n;
    const double variance = std::max(0.0, sum.square / n - mean * mean) / (n - 1);
    const std::size_t at = 6 * (i / 3) + i % 3;
    out.pixels[at] = static_cast<float>(values[i] * mean);
    out.pixels[at + 3] = static_cast<float>(values[i] * values[i] * variance);
  }
  return out;
}

// Relative noise of every pixel and channel: that of its own samples.
Values relative_noise(int n, Random& random) {
  std::gamma_distribution<double> gamma(n, 1);
  Values noise(3UL * kSimulatedSide_px * kSimulatedSide_px);
  for (double& value : noise) value = gamma(random) / n - 1;
  return noise;
}

// At the edge of the image the pixels beyond it are those of the edge.
Values filtered(const Values& noise) {
  Values out(noise.size());
  const auto inside = [](int at) { return std::clamp(at, 0, kSimulatedSide_px - 1); };
  for (int y = 0; y < kSimulatedSide_px; ++y)
    for (int x = 0; x < kSimulatedSide_px; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        for (int v = -1; v <= 1; ++v)
          for (int u = -1; u <= 1; ++u)
            out[3 * simulated_index(x, y) + c] +=
                noise[3 * simulated_index(inside(x + u), inside(y + v)) + c] / 9;
  return out;
}

Values repeated(const Values& noise) {
  Values out(noise.size());
  for (int y = 0; y < kSimulatedSide_px; ++y)
    for (int x = 0; x < kSimulatedSide_px; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        out[3 * simulated_index(x, y) + c] = noise[3 * simulated_index(x % kRepeat_px, y % kRepeat_px) + c];
  return out;
}

Values shared(Values noise, int n, Random& random) {
  constexpr double kShare = 0.1;
  std::normal_distribution<double> normal(0, kShare / std::sqrt(n));
  const double of_all = normal(random);
  for (double& value : noise) value += of_all;
  return noise;
}

Values noise_in_common(InCommon in_common, int n, Random& random) {
  auto noise = relative_noise(n, random);
  if (in_common == InCommon::Filtered) return filtered(noise);
  if (in_common == InCommon::Repeated) return repeated(noise);
  return shared(std::move(noise), n, random);
}

}  // namespace

std::size_t simulated_index(int x, int y) {
  return static_cast<std::size_t>(y) * kSimulatedSide_px + static_cast<std::size_t>(x);
}

Values simulated_values() {
  Values values(3UL * kSimulatedSide_px * kSimulatedSide_px);
  for (int y = 0; y < kSimulatedSide_px; ++y)
    for (int x = 0; x < kSimulatedSide_px; ++x) {
      const double slope = 0.1 + 0.2 * x / kSimulatedSide_px + 0.1 * y / kSimulatedSide_px;
      const bool is_bright = (x / 6 + y / 6) % 2 == 0;
      for (std::size_t c = 0; c < 3; ++c)
        values[3 * simulated_index(x, y) + c] =
            slope * (is_bright ? 2 : 1) * (1 - 0.1 * static_cast<double>(c));
    }
  return values;
}

image::Image simulated_image(const Values& values, const SampleLaw& law, int n, Random& random) {
  if (law.in_common == InCommon::Nothing) return with_own_noise(values, law, n, random);
  auto out = image::make_image(kSimulatedSide_px, kSimulatedSide_px, {"R", "G", "B"});
  const auto noise = noise_in_common(law.in_common, n, random);
  for (std::size_t i = 0; i < values.size(); ++i)
    out.pixels[i] = static_cast<float>(values[i] * (1 + noise[i]));
  return out;
}

image::Image simulated_reference(const SampleLaw& law, int n, Random& random) {
  const auto values = simulated_values();
  if (!law.is_computed) return with_own_noise(values, {"", law.has_fireflies}, n, random);
  auto out = image::make_image(kSimulatedSide_px, kSimulatedSide_px, {"R", "G", "B"});
  for (std::size_t i = 0; i < values.size(); ++i) out.pixels[i] = static_cast<float>(values[i]);
  return out;
}

}  // namespace orbs::studies

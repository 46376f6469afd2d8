#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

namespace orbs::studies {

/// What one kind of gate does with images whose error is known: simulated renders, whose pixels are sums of
/// independent samples, judged look by look as those of a run, and once with a fixed number of samples.
struct LooksRow {
  std::string samples;  // the law of the samples, see simulated_images.h
  std::string gate;     // "mean_ratio"
  double error = 0;     // in limits of the gate
  int sequences = 0;
  int failed = 0;
  int passed = 0;
  double mean_spp = 0;  // when the sequence ended
  int fixed_failed = 0;
  int fixed_passed = 0;
};

struct LooksSettings {
  int sequences = 100;
  int threads = 0;
  std::uint64_t seed = 1;
};

/// The number of samples of the fixed test.
inline constexpr int kFixedSpp = 256;

/// Every kind of gate (mean ratio, tile, edges, PSNR) with errors of 0, 1, 1.5 and 3 limits, for samples of
/// an exponential law and for those of which a few are very bright; all gates together with errors of 0 and 3
/// limits of the mean for fireflies that are compared with a formula, and for noise that pixels have in
/// common. No result depends on the threads. Fewer sequences when stopped.
std::vector<LooksRow> simulate_looks(const LooksSettings& settings, const std::atomic<bool>* stop);

}  // namespace orbs::studies

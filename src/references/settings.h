#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>

namespace orbs::references {

constexpr int kMostReferenceSpp = 1 << 20;

/// How far the noise of a reference must lie below the psnr_srgb8 gates of its cases.
constexpr double kReferenceMargin_db = 10;

struct ReferenceSettings {
  int spp = 0;  // 0: as many as the margin needs
  /// Seed of the first pass; later passes count up. Far from the seeds of runs, as a result must not share
  /// the samples, and so the errors, of its reference.
  int seed = 1000003;
  int threads = 0;
  std::string reason;  // why existing references are replaced; "": they are kept
};

struct ReferenceContext {
  std::filesystem::path tracer;
  const std::atomic<bool>* stop = nullptr;
  std::function<void(const std::string&)> say;
};

}  // namespace orbs::references

#pragma once

#include "references/noise_limits.h"
#include "references/unfinished.h"
#include "registry/analytic.h"

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace orbs::references {

constexpr int kMostReferenceSpp = 1 << 20;

struct ReferenceSettings {
  int spp = 0;  // 0: as many as the noise needs
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

/// A reference to be rendered, and what is required of it.
struct WantedReference {
  std::string name;
  std::filesystem::path file;
  std::filesystem::path target;
  int spp = 64;                           // of the case: the first pass
  ReferenceNoise most_noise = kAnyNoise;  // that its cases leave room for
  std::size_t pixels = 0;                 // of the camera
  std::string camera = {};                // one of the file's "cameras"; "": its "camera"
  bool split_paths = false;
  std::optional<registry::AnalyticReference> analytic = {};  // then it is computed and not rendered
};

struct RenderedReference {
  PassSum sum;
  image::Image image;  // its mean, with all layers
  ReferenceNoise noise;
};

/// Renders passes with the seeds settings.seed, settings.seed + 1, ... until the noise is low enough or
/// kMostReferenceSpp is reached; with settings.spp, exactly that many samples. Passes that an earlier call
/// has left in `unfinished` are not rendered again. Nothing when stopped. InputError with the tracer's last
/// words when it fails: a fault of ours or of the scene.
std::optional<RenderedReference> render_reference(const WantedReference& wanted,
                                                  const ReferenceSettings& settings,
                                                  const ReferenceContext& context,
                                                  const UnfinishedReference& unfinished);

}  // namespace orbs::references

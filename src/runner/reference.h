#pragma once

#include "image/image.h"
#include "registry/configuration.h"
#include "scene/scene.h"

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>

namespace orbs::runner {

constexpr int kMostReferenceSpp = 1 << 20;

/// How far the noise of a reference must lie below the gate of its cases.
constexpr double kReferenceMargin_db = 10;

struct ReferenceSettings {
  int spp = 0;  // 0: as many as the margin needs
  /// Far from the seeds of runs: a result must not share the samples, and so the errors, of its reference.
  int seed = 1000003;
  int threads = 0;
  std::string reason;  // given: references may be replaced
};

struct ReferenceContext {
  std::filesystem::path tracer;
  const std::atomic<bool>* stop = nullptr;
  std::function<void(const std::string&)> say;
};

/// Renders the references of the scenes that the selection chooses and puts each into place when it is
/// complete. Returns 0, or 1 when one is noisier than its gate allows, or 130 when stopped. InputError before
/// anything is rendered when a reference exists and no reason is given.
int render_references(const registry::Configuration& configuration,
                      const registry::Defaults& selection,
                      const ReferenceSettings& settings,
                      const ReferenceContext& context);

/// Changes whenever the picture may: all of the scene's text, its meshes, and the files of its textures and
/// IES profiles.
std::uint64_t scene_content_hash(const scene::Scene& scene, const std::filesystem::path& file);

/// Share of each light-path class in the mean radiance (R + G + B) of a picture with layers
/// "path.<class>.R/G/B", by class.
std::map<std::string, double> path_shares(const image::Image& picture);

/// R, G, B and their variances alone.
image::Image without_layers(const image::Image& picture);

}  // namespace orbs::runner

#pragma once

#include "registry/configuration.h"

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>

namespace orbs::runner {

constexpr int kMostReferenceSpp = 1 << 20;

/// How far the noise of a reference must lie below the gate of its cases.
constexpr double kReferenceMargin_db = 10;

struct ReferenceSettings {
  int spp = 0;  // 0: as many as the margin needs
  /// Of the first pass; later ones count up. Far from the seeds of runs: a result must not share the samples,
  /// and so the errors, of its reference.
  int seed = 1000003;
  int threads = 0;
  std::string reason;  // given: references may be replaced
};

struct ReferenceContext {
  std::filesystem::path tracer;
  const std::atomic<bool>* stop = nullptr;
  std::function<void(const std::string&)> say;
};

/// Renders the references of the scenes that the selection chooses, as good as every case that looks at them
/// needs, and puts each into place when it is complete: those that are missing, and with a reason all of
/// them. A scene that is judged by the reference of another one gets none. Returns 0, or 1 when one is
/// noisier than its gate allows, or 130 when stopped: the next call goes on with the passes that are whole.
/// InputError before anything is rendered when none is missing and no reason is given, or a history is
/// broken; later when another call renders the same one.
int render_references(const registry::Configuration& configuration,
                      const registry::Defaults& selection,
                      const ReferenceSettings& settings,
                      const ReferenceContext& context);

}  // namespace orbs::runner

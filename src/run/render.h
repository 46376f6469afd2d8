#pragma once

#include "adapters/job.h"
#include "adapters/process/isolation.h"
#include "adapters/process/process.h"
#include "registry/configuration.h"
#include "run/outcome.h"

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// The one way to start a renderer, for runs and studies alike.
namespace orbs::run {

struct RenderJob {
  registry::Renderer renderer;          // with the limits of this render
  std::vector<adapters::Job> replicas;  // one process each; the first one's folder holds the scene
  std::optional<adapters::Isolation> isolation{};
  std::filesystem::path came_back{};  // holds the images that were rendered elsewhere; "": they are rendered
};

struct Rendered {
  Outcome outcome;
  std::filesystem::path image;                     // the mean of all replicas, or what the last of them left
  std::vector<adapters::ProcessResult> processes;  // of the replicas that were started
  std::optional<double> render_seconds;            // of all of them, as the renderer itself states
};

/// Starts one process after the other, until one leaves no usable image, and classifies the outcome. Touches
/// only the folder of the replicas, which exists. Several images become one with their mean and variance.
Rendered render(const RenderJob& job, const std::atomic<bool>* stop);

/// The variables that the renderer gets for the job.
std::vector<std::string> environment_of(const registry::Renderer& renderer, const adapters::Job& job);

}  // namespace orbs::run

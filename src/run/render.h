#pragma once

#include "adapters/job.h"
#include "adapters/process/isolation.h"
#include "adapters/process/process.h"
#include "image/image.h"
#include "registry/configuration.h"
#include "run/outcome.h"
#include "run/plan/plan.h"

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// The one way to start a renderer, for runs and studies alike.

namespace orbs::run {

/// What one render costs as a process: its start, the scene file and the image file are in these times.
struct RenderCost {
  int spp = 0;
  double cpu_seconds = 0;  // user and system
  double wall_seconds = 0;
  double supervisor_cpu_seconds = 0;               // of the supervisor, beside that
  std::optional<double> traversal_share;           // of its threads' time; only the built-in tracer says it
  std::optional<double> samples_cpu_seconds = {};  // likewise: without start, reading and writing
  std::optional<double> render_seconds = {};       // that the renderer states, see registry::RenderSeconds
  std::optional<double> trial_seconds = {};        // likewise: the part of them that trial renderings took
  /// Images for each one that counts: more than 1 where a seed is the last of as many images of a run.
  double images = 1;
};

/// A renderer and the scene file that has been written for it.
struct PreparedRender {
  ChosenRenderer renderer;  // with the limits of these renders
  scene::Scene scene;
  adapters::JobSettings settings;
  std::filesystem::path folder;
  bool is_built_in = false;  // it reports the time inside ray traversal
  std::optional<adapters::Isolation> isolation{};
};

struct RenderSettings {
  int spp = 64;
  int seed = 1;  // the first is 1
  int threads = 1;
  std::vector<std::string> more_arguments{};  // behind those of the entry's command
  bool may_be_negative = false;               // negative values are right, as of colours beyond Rec.709
};

struct RenderedImage {
  RenderCost cost;
  image::Image image;
};

/// Makes `folder` and writes the scene into it. In a sandbox if the plan's settings say so, and within
/// `case_seconds` where the case of the scene has a limit. InputError when the renderer cannot render the
/// scene.
PreparedRender prepare_render(const ChosenRenderer& renderer,
                              const Plan& plan,
                              const scene::Scene& scene,
                              const std::filesystem::path& folder,
                              double case_seconds = 0);

/// One render in the prepared folder, as a run makes it: a renderer with seed replicas is started once for
/// each, and no two renders share a seed. Nothing when stopped. InputError, with the renderer's last words,
/// when there is no usable image.
std::optional<RenderedImage> render_once(const PreparedRender& prepared,
                                         const RenderSettings& settings,
                                         const std::atomic<bool>* stop);

struct RenderJob {
  registry::Renderer renderer;          // with the limits of this render
  std::vector<adapters::Job> replicas;  // one process each; the first one's folder holds the scene
  std::optional<adapters::Isolation> isolation{};
  std::filesystem::path within{};  // ours; between it and the folder of the replicas, renderers write, too
  std::vector<std::filesystem::path> inputs{};  // that the renders of one scene must not change
  std::filesystem::path came_back{};  // holds the images that were rendered elsewhere; "": they are rendered
};

struct Rendered {
  Outcome outcome;
  std::filesystem::path image;                     // the mean of all replicas, or what the last of them left
  std::vector<image::Image> renders;               // of several replicas, if all have left one
  std::vector<adapters::ProcessResult> processes;  // of the replicas that were started
  std::optional<double> render_seconds;            // of all of them, as the renderer itself states
  std::optional<double> trial_seconds;             // likewise
};

/// Starts one process after the other, until one leaves no usable image, and classifies the outcome. Touches
/// only the folder of the replicas, which exists, and those between it and `within`. An image is Stale when
/// one of the inputs has changed meanwhile. Several images become one with their mean and variance.
Rendered render(const RenderJob& job, const std::atomic<bool>* stop);

/// The variables that the renderer gets for the job.
std::vector<std::string> environment_of(const registry::Renderer& renderer, const adapters::Job& job);

}  // namespace orbs::run

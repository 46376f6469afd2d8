#pragma once

#include "adapters/job.h"
#include "base/scratch_folder.h"
#include "image/image.h"
#include "runner/plan.h"
#include "studies/bench.h"

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace orbs::studies {

/// A renderer with the scene that it reads, already written.
struct BenchSubject {
  runner::ChosenRenderer renderer;
  scene::Scene scene;
  adapters::JobSettings settings;
  std::filesystem::path folder;
  bool is_built_in = false;  // it reports the time inside ray traversal
};

struct BenchRenderSettings {
  int spp = 64;
  int seed = 1;
  int threads = 1;
  std::vector<std::string> more_arguments{};  // for the built-in tracer
  bool may_be_negative = false;               // the pixels, as colours beyond Rec.709 are
};

struct BenchImage {
  BenchRender render;
  image::Image image;
};

/// Makes `folder` and writes the scene into it. InputError when the renderer cannot render the scene.
BenchSubject prepare_subject(const runner::ChosenRenderer& renderer,
                             const runner::Plan& plan,
                             const scene::Scene& scene,
                             const std::filesystem::path& folder);

/// Nothing when stopped. InputError, with the renderer's last words, when there is no usable image.
std::optional<BenchImage> render(const BenchSubject& subject,
                                 const BenchRenderSettings& settings,
                                 const std::atomic<bool>* stop);

}  // namespace orbs::studies

#pragma once

#include "image/image.h"
#include "scene/scene.h"
#include "studies/seed_statistics.h"

#include <atomic>
#include <filesystem>
#include <optional>

namespace orbs::studies {

/// What the harness adds to each render. The "renderer" copies a finished image, so that little but the
/// harness's own work is left. The programs of orbs are loaded once a run, not once a render, and are not in
/// it; neither is the judging of the image.
struct Overhead {
  Spread harness_ms;  // scene written, command run by its supervisor, image read and checked, folder in place
  Spread bare_ms;     // posix_spawn of the same command, and waiting for it
};

/// CPU time that our own programs take before they do anything.
struct Start {
  Spread orbs_version_ms;    // orbs --version
  Spread tracer_version_ms;  // orbs-tracer --version
  Spread pixel_ms;           // orbs-tracer, a scene at 1 x 1 px with one sample: with reading and writing
};

/// All in turns, `rounds` times, by the programs in `build`. InputError when one of them fails.
Start measure_start(const std::filesystem::path& build,
                    const std::filesystem::path& scene,
                    int rounds,
                    const std::filesystem::path& scratch);

/// Both in turns, `rounds` times, with `image` as the result. Nothing when stopped. InputError when the
/// command fails.
std::optional<Overhead> measure_overhead(const scene::Scene& scene,
                                         const image::Image& image,
                                         int rounds,
                                         const std::filesystem::path& scratch,
                                         const std::atomic<bool>* stop);

}  // namespace orbs::studies

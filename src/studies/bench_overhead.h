#pragma once

#include "image/image.h"
#include "scene/scene.h"
#include "studies/bench.h"

#include <atomic>
#include <filesystem>
#include <optional>

namespace orbs::studies {

/// Both in turns, `rounds` times, with `image` as the result. Nothing when stopped. InputError when the
/// command fails.
std::optional<Overhead> measure_overhead(const scene::Scene& scene,
                                         const image::Image& image,
                                         int rounds,
                                         const std::filesystem::path& scratch,
                                         const std::atomic<bool>* stop);

}  // namespace orbs::studies

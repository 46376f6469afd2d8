#pragma once

#include "registry/configuration.h"
#include "run/plan/plan.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace orbs::run {

/// The file of render times that comes with the program: data/bench/render-times.json below the root of the
/// plan. It holds one suite at one size.
std::filesystem::path shipped_times_file(const Plan& plan);

/// What a render is expected to take by the times that come with the program.
struct ShippedTime {
  double cpu_seconds = 1;
  bool is_rough = false;  // by other sizes or other scenes
};

/// By job: the CPU seconds that its render took on another machine, scaled to its samples and to its size.
/// For a render that is not in the file, roughly: by the samples and pixels of the others of its renderer, or
/// of all renderers. None without the file. InputError when it cannot be read.
std::vector<std::optional<ShippedTime>> shipped_cpu_seconds(const Plan& plan);

/// The same; 1 for all where none is known.
std::vector<double> estimated_cpu_seconds(const Plan& plan);

/// The render time in seconds that the renderer reports itself: in its output, or in a JSON file that it has
/// left in `folder`. Nothing where it reports none, or no number.
std::optional<double> render_seconds(const registry::RenderSeconds& place,
                                     const std::string& output,
                                     const std::filesystem::path& folder);

/// Removes the file with the render time that an earlier render may have left.
void forget_render_seconds(const registry::RenderSeconds& place, const std::filesystem::path& folder);

}  // namespace orbs::run

#pragma once

#include "registry/configuration.h"

#include <filesystem>
#include <optional>
#include <string>

namespace orbs::run {

/// The render time in seconds that the renderer reports itself: in its output, or in a JSON file that it has
/// left in `folder`. Nothing where it reports none, or no number.
std::optional<double> render_seconds(const registry::RenderSeconds& place,
                                     const std::string& output,
                                     const std::filesystem::path& folder);

/// Removes the file with the render time that an earlier render may have left.
void forget_render_seconds(const registry::RenderSeconds& place, const std::filesystem::path& folder);

}  // namespace orbs::run

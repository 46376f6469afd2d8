#pragma once

#include "registry/configuration.h"

#include <filesystem>
#include <optional>
#include <string>

namespace orbs::runner {

/// The time that a renderer says itself that it has rendered: in its output, or in a JSON file that it has
/// left in `folder`. Nothing where it says none, or nothing that is a number.
std::optional<double> render_seconds(const registry::RenderSeconds& place,
                                     const std::string& output,
                                     const std::filesystem::path& folder);

/// Removes the file that says so, if a render before has left it there.
void forget_render_seconds(const registry::RenderSeconds& place, const std::filesystem::path& folder);

}  // namespace orbs::runner

#pragma once

#include "registry/configuration.h"

#include <string>
#include <vector>

namespace orbs::registry {

/// The name of the entry that the renderer is, or is a variant of.
const std::string& entry_of(const Renderer& renderer);

/// The names of the renderers that a comma-separated list of names and patterns chooses. The name of an entry
/// with variants chooses all of them, and "*" chooses none that is only_when_named. InputError, with the
/// nearest name, for a pattern that chooses nothing.
std::vector<std::string> chosen_renderers(const Configuration& configuration, const std::string& list);

/// The entry with the exporter's settings that it has at the reduced size instead of its usual ones.
Renderer at_size(Renderer renderer, SizeDivisor size_divisor);

/// The entry with the exporter's settings that it has for the scene of that name, which stand above those of
/// the size.
Renderer for_scene(Renderer renderer, const std::string& scene);

}  // namespace orbs::registry

#pragma once

#include "registry/configuration.h"

#include <filesystem>
#include <string>
#include <vector>

namespace orbs::registry {

/// What is known of a renderer that is to be added; the rest is for its user to fill in.
struct NewRenderer {
  std::string name;
  std::string executable{};  // "" for a program of its name
  std::string scene_format = "orbs-scene";
  std::string native_scenes{};
  std::string declares = "G1/M1/L1/A1";
  std::vector<std::string> version{"--version"};  // arguments that make it print its version; none: it cannot
  std::vector<std::string>
      command{};  // none: that of the first renderer with the same format, or a usual one
};

/// Adds an entry to the user's own file of `configuration`, at the end, and leaves every other byte as it is.
/// The new text is read as any configuration before it takes the place of the old one. Returns the entry.
/// InputError when the name is taken, or when the entry would be none that can be read: the file is untouched
/// then.
Renderer add_renderer(const Configuration& configuration, const NewRenderer& added);

/// The entry that add_renderer would add, with the same errors; nothing is written.
Renderer entry_of(const Configuration& configuration, const NewRenderer& added);

}  // namespace orbs::registry

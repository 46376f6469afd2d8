#pragma once

#include "registry/configuration.h"

#include <filesystem>
#include <string>

namespace orbs::registry {

/// A suite in a configuration of one's own, which may not be there yet.
struct NewSuite {
  Suite suite;
  std::filesystem::path file;  // the configuration
  std::string text;            // that it is to have
};

/// The suite `name` of the configuration in `folder`: the one that is there, or a new one in its folders
/// `cases` and `references`. A configuration that is not there yet has it as its default. Writes nothing.
/// InputError where the configuration is broken.
NewSuite suite_in(const std::filesystem::path& folder, const std::string& name);

}  // namespace orbs::registry

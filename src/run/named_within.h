#pragma once

#include <filesystem>
#include <string>

namespace orbs::run {

/// The text with paths into `folder` named relative to it: the folder of a render is moved when it is
/// complete.
std::string named_within(const std::filesystem::path& folder, std::string text);

}  // namespace orbs::run

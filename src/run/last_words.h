#pragma once

#include <filesystem>
#include <string>

namespace orbs::run {

/// The line of a failed renderer's output that says most about why: of the last lines that are not empty the
/// first that names an error ("Error: ...", "ValueError: ..."), since later ones often are what follows from
/// it; else the last line. Terminal escape sequences are dropped, paths within `folder` are named relative to
/// it, and at most 200 bytes are kept. "" for an output without text.
std::string last_words(const std::string& output, const std::filesystem::path& folder);

}  // namespace orbs::run

#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace orbs::run {

/// The files below the folder that look like images by their endings, or have the name `image` but for its
/// ending, relative to it. No link is followed, and of a huge folder only a part is searched.
std::set<std::string> other_images(const std::filesystem::path& folder, const std::string& image);

/// ", but seed-2770001.exr": what is among `after` and not among `before`, the nearest to `image` first; ""
/// for nothing.
std::string misnamed_text(const std::string& image,
                          const std::set<std::string>& before,
                          const std::set<std::string>& after);

}  // namespace orbs::run

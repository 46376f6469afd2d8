#pragma once

#include <cstddef>
#include <filesystem>

namespace orbs::supervisor {

/// Bytes of all regular files in the folder and the folders in it; symbolic links are not followed. Files
/// that disappear meanwhile count nothing.
std::size_t folder_size(const std::filesystem::path& folder);

}  // namespace orbs::supervisor

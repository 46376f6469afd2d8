#pragma once

#include <cstddef>
#include <filesystem>

namespace orbs::supervisor {

/// Bytes of all regular files in the folder and the folders in it; symbolic links are not followed. Files
/// that disappear meanwhile count nothing. More than 200 folders within each other count as more than any
/// limit.
std::size_t folder_size(const std::filesystem::path& folder);

}  // namespace orbs::supervisor

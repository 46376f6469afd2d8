#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace orbs::results {

/// Beside the references of a suite: the pixel hash of each, as it was accepted.
inline constexpr const char* kImageHashesFile = "image-hashes.json";

/// By name of the reference: the "image_hash" of its pixels (format "orbs-image-hashes/1"). Empty if there is
/// no such file. InputError if it is broken.
std::map<std::string, std::string> read_image_hashes(const std::filesystem::path& references);

/// Writes the file. WriteError when the disk refuses.
void write_image_hashes(const std::map<std::string, std::string>& hashes,
                        const std::filesystem::path& references);

}  // namespace orbs::results

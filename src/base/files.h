#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace orbs {

/// The whole file as bytes. InputError with the reason when it cannot be read.
std::string read_file(const std::filesystem::path& path);

/// Why there is no file to be read at `path`: none, or a folder, a device, a link that leads nowhere; "" for
/// a file.
std::string no_file_problem(const std::filesystem::path& path);

/// Writes beside the target and renames into place, so that a reader sees the old file or the new one, never
/// a part. WriteError when the disk refuses.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// For who will write this file after long work: InputError when something else is there (a folder, a device)
/// or its folder is not, WriteError when nothing can be written beside it. What is there stays as it is.
void check_output_file(const std::filesystem::path& path);

/// Makes the folder and those above it, unless they are there. WriteError with the reason when it cannot be.
void make_folder(const std::filesystem::path& folder);

/// Puts the folder `finished` into the place of `target`, of which it must be a neighbour on the disk:
/// whoever looks sees the old folder, none, or the new one whole, after a power cut too. Makes the folders
/// above. WriteError when the disk refuses.
void put_in_place(const std::filesystem::path& finished, const std::filesystem::path& target);

/// FNV-1a, 64 bits (Fowler, Noll, Vo; draft-eastlake-fnv): tells two versions of a file apart, no protection
/// against somebody who wants them to collide.
std::uint64_t content_hash(std::string_view bytes, std::uint64_t seed = 0xcbf29ce484222325ULL);

/// content_hash as 16 hexadecimal digits, the form that provenance records and job ids use.
std::string hash_text(std::uint64_t hash);

/// Absolute path of `relative` read against `base_folder`; absolute paths stay as they are.
std::filesystem::path resolve_path(const std::filesystem::path& base_folder, const std::string& relative);

}  // namespace orbs

#pragma once

#include <filesystem>
#include <string>

namespace orbs {

/// Device, inode, size and times of a file as text: another text after each change of its content, even one
/// that keeps the size or sets the time of modification back, since nobody can set the time of change. "" if
/// there is no such file. Symbolic links are followed.
std::string file_state(const std::filesystem::path& file);

/// The same of an open file.
std::string file_state(int descriptor);

}  // namespace orbs

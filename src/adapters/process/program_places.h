#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// What of the disk a program needs beside the folders of the system.
namespace orbs::adapters {

/// The files and folders that a program reads as it starts, absolute: itself and its folder; of a program in
/// <prefix>/bin the prefix, as of Python's virtual environments; the same where symbolic links lead; and of a
/// script its interpreter, likewise. In a folder that holds more than programs (the root, the home folder,
/// the temporary folder, and those above them) it is the file alone.
std::vector<std::filesystem::path> program_places(const std::filesystem::path& program);

/// The files and folders that words of a command line, or variables (NAME=value), name by absolute paths:
/// "/a", "--plugin=/a", "+I\"/a\"", "LD_LIBRARY_PATH=/a:/b". Of a file as program_places; a folder that holds
/// more than programs is not among them.
std::vector<std::filesystem::path> named_places(const std::vector<std::string>& words);

}  // namespace orbs::adapters

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace orbs::adapters {

/// The environment for a renderer: PATH, HOME, USER, LOGNAME and TMPDIR of ours, a C.UTF-8 locale so that
/// numbers in its output look alike everywhere, and the variables in `allowed` (NAME copies ours where we
/// have one, NAME=value sets it).
std::vector<std::string> child_environment(const std::vector<std::string>& allowed);

/// The file behind a program: `program` itself when it has a slash, else the first match on PATH. Nothing
/// when it is not there or not executable.
std::optional<std::filesystem::path> find_program(const std::string& program);

/// Why find_program finds nothing: "'x' was not found", or that the file is there and may not be executed,
/// with the command that changes it.
std::string program_problem(const std::string& program);

}  // namespace orbs::adapters

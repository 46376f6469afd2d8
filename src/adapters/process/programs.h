#pragma once

#include "base/text.h"

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

namespace orbs::adapters {

/// The environment for a renderer: PATH, HOME, USER, LOGNAME and TMPDIR of ours, a C.UTF-8 locale so that
/// numbers in its output look alike everywhere, and the variables in `allowed` (NAME copies ours where we
/// have one, NAME=value sets it).
inline std::vector<std::string> child_environment(const std::vector<std::string>& allowed) {
  std::vector<std::string> names{"PATH", "HOME", "USER", "LOGNAME", "TMPDIR", "LC_ALL=C.UTF-8"};
  names.insert(names.end(), allowed.begin(), allowed.end());
  std::vector<std::string> out;
  for (const auto& name : names) {
    const auto key = name.substr(0, name.find('='));
    std::erase_if(out, [&](const auto& entry) { return entry.starts_with(key + "="); });
    if (key != name) {
      out.push_back(name);
    } else if (const char* value = std::getenv(name.c_str()); value != nullptr) {
      out.push_back(fmt::format("{}={}", name, value));
    }
  }
  return out;
}

/// The file behind a program: `program` itself when it has a slash, else the first match on PATH. Nothing
/// when it is not there or not executable.
inline std::optional<std::filesystem::path> find_program(const std::string& program) {
  const auto usable = [](const std::filesystem::path& file) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(file, ignored) && ::access(file.c_str(), X_OK) == 0;
  };
  if (program.find('/') != std::string::npos) {
    const auto file = std::filesystem::absolute(program).lexically_normal();
    return usable(file) ? std::optional(file) : std::nullopt;
  }
  const char* path = std::getenv("PATH");
  for (const auto& folder : split(path == nullptr ? "/usr/local/bin:/usr/bin:/bin" : path, ':'))
    if (!program.empty() && !folder.empty() && usable(std::filesystem::path(folder) / program))
      return std::filesystem::absolute(std::filesystem::path(folder) / program).lexically_normal();
  return std::nullopt;
}

/// Why find_program finds nothing: "'x' was not found", or that the file is there and may not be executed,
/// with the command that changes it.
inline std::string program_problem(const std::string& program) {
  std::error_code ignored;
  if (program.find('/') == std::string::npos || !std::filesystem::is_regular_file(program, ignored))
    return fmt::format("'{}' was not found", program);
  return fmt::format("'{0}' is there, but it may not be executed; chmod +x {1} permits it", program,
                     shell_text({program}));
}

}  // namespace orbs::adapters

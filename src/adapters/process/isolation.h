#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace orbs::adapters {

/// What a command sees under bubblewrap: all files read-only, `folder` writable, /tmp empty and its own,
/// `hidden` folders empty, no network. `readable` folders are seen even if they lie in /tmp.
struct Isolation {
  std::filesystem::path folder;
  std::vector<std::filesystem::path> readable;
  std::vector<std::filesystem::path> hidden;
};

/// The command line that runs `argv` so; argv[0] is absolute. Paths that are not there are left out.
/// InputError when there is no bwrap.
std::vector<std::string> isolated(const std::vector<std::string>& argv, const Isolation& isolation);

/// Why this machine cannot isolate a command: bwrap is missing, or its kernel or container refuses
/// namespaces. "" when it can. Tries it.
std::string why_not_isolated();

}  // namespace orbs::adapters

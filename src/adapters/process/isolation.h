#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace orbs::adapters {

/// What a command sees under bubblewrap beside the folders of the system (/usr and what programs need of
/// /etc): nothing but what is named here. Its processes, System V memory, host name, network, /proc, /dev,
/// /tmp, /dev/shm and home folder are its own, the last three empty at the start, and it has no rights of
/// root over the rest.
struct Isolation {
  std::filesystem::path folder;                 // writable; where it starts
  std::vector<std::filesystem::path> readable;  // folders and files
  std::vector<std::filesystem::path> hidden;    // folders and files that are empty in what is readable
  std::vector<std::filesystem::path> inputs;    // files that it reads, also in hidden folders
  std::optional<std::size_t> memory_bytes;      // most that /tmp, /dev/shm and home may hold, each; nothing:
                                                // half of the machine's memory
};

/// Whether it is a folder of the system, which every command sees whole, or lies in one: but for /usr/local
/// and /usr/src, where anything may lie.
bool is_of_system(const std::filesystem::path& path);

/// The command line that runs `argv` so; argv[0] is absolute. Paths that are not there are left out.
/// InputError when there is no bwrap.
std::vector<std::string> isolated(const std::vector<std::string>& argv, const Isolation& isolation);

/// Why this machine cannot isolate a command: bwrap is missing, or its kernel or container refuses
/// namespaces. "" when it can. Tries it.
std::string why_not_isolated();

}  // namespace orbs::adapters

#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// The references that a scene had before: <scene>.history.json beside the reference, format
/// "orbs-history/2". Entries are only ever added.
namespace orbs::references {

struct ReplacedReference {
  std::string replaced;  // when: local time, ISO 8601
  std::string reason;    // why, as --accept said
  std::string problem;   // why its file could not be read; "" when it could
  std::map<std::string, std::string> provenance;
};

/// The file for the reference in `reference`.
std::filesystem::path history_file(const std::filesystem::path& reference);

/// From the oldest to the newest; none when there is no file. InputError when it cannot be read.
std::vector<ReplacedReference> read_history(const std::filesystem::path& reference);

/// Adds the provenance of the current reference, with the hash of its pixels, to its history. A reference
/// that is noted already, because its replacement was interrupted, is not noted twice. InputError as
/// read_history, WriteError when the disk refuses.
void note_replaced(const std::filesystem::path& reference, const std::string& reason);

}  // namespace orbs::references

#pragma once

#include "results/record.h"

#include <filesystem>
#include <functional>
#include <string>

namespace orbs::server {

/// What an edit makes of a file.
struct EditedText {
  std::filesystem::path file;
  std::string before;
  std::string after;
  int line = 1;  // of `after`, where the new entry begins
};

/// What the page may change. The server knows neither the configuration nor its rules.
struct Editor {
  /// The user's configuration file as it is now, and with the failures of this record as known ones; writes
  /// nothing. `until`: the last day on which they are accepted, or "". InputError says what is wrong.
  std::function<EditedText(const results::RunRecord&, const std::string& reason, const std::string& until)>
      accept_failure;
  /// Puts the text in the place of the file's.
  std::function<void(const std::filesystem::path&, const std::string& text)> write;
};

}  // namespace orbs::server

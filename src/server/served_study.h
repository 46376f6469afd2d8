#pragma once

#include "base/files_inside.h"

#include <filesystem>
#include <string>

namespace orbs::server {

/// One study of cost or stability in the server's memory. Only its start is kept: the page reads its JSON as
/// a file of the folder, as it is then. Its folder is kept open, so that what takes its name later leads
/// nowhere.
class ServedStudy {
 public:
  /// InputError if the folder holds no study.
  explicit ServedStudy(const std::filesystem::path& folder);

  /// The folder as it was named, for people.
  const std::filesystem::path& named() const { return named_; }
  /// Where its files are read: leads to the same folder whatever becomes of the name.
  std::filesystem::path folder() const { return opened_.path(); }
  const std::string& started() const { return started_; }
  /// "cost" or "stability".
  const char* kind() const { return is_stability_ ? "stability" : "cost"; }

 private:
  std::filesystem::path named_;
  bool is_stability_;
  std::string started_;
  OpenFolder opened_;
};

}  // namespace orbs::server

#pragma once

#include "results/run_folder.h"

#include <chrono>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace orbs::server {

/// One run as the server holds it: read once, brought up to date while the run goes on and its folder is
/// there. All members may be called from any thread.
class ServedRun {
 public:
  /// InputError when the folder holds no run.
  explicit ServedRun(const std::filesystem::path& folder);

  const std::filesystem::path& folder() const { return folder_; }
  std::string started() const;

  /// The texts of report::overview_json and its siblings.
  std::shared_ptr<const std::string> overview();
  std::optional<std::string> target(std::size_t index);
  std::string progress();

  /// Grows whenever the run changes; looks at the folder at most every `kLookInterval`.
  std::uint64_t version();
  bool is_live();

 private:
  void look();

  static constexpr std::chrono::milliseconds kLookInterval{400};
  std::filesystem::path folder_;
  mutable std::mutex mutex_;
  results::RunView view_;
  std::uint64_t version_ = 1;
  std::chrono::steady_clock::time_point last_look_;
  std::shared_ptr<const std::string> overview_;  // of the present version; nothing until somebody asks
};

}  // namespace orbs::server

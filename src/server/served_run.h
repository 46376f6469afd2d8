#pragma once

#include "results/run_folder.h"

#include <chrono>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace orbs::server {

/// One run in the server's memory: read once, and updated as long as the run goes on and its folder exists.
/// All members may be called from any thread.
class ServedRun {
 public:
  /// InputError if the folder holds no run.
  explicit ServedRun(const std::filesystem::path& folder);

  const std::filesystem::path& folder() const { return folder_; }
  std::string started() const;

  /// The texts of report::overview_json, target_json and progress_json.
  std::shared_ptr<const std::string> overview();
  std::optional<std::string> target(std::size_t index);
  std::string progress();

  /// Grows whenever the run changes. Reads the folder at most once per `kPollInterval`.
  std::uint64_t version();
  bool is_live();

 private:
  void look();

  static constexpr std::chrono::milliseconds kPollInterval{400};
  std::filesystem::path folder_;
  mutable std::mutex mutex_;
  results::RunView view_;
  std::uint64_t version_ = 1;
  std::chrono::steady_clock::time_point last_look_;
  std::shared_ptr<const std::string> overview_;  // of the current version; null until requested
};

}  // namespace orbs::server

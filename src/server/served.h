#pragma once

#include "base/files_inside.h"
#include "results/run_folder.h"
#include "results/study_kinds.h"
#include "server/packed_text.h"

#include <chrono>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace orbs::server {

/// Names of the runs in these absolute folders, for the page and its links: the folder's name, preceded by as
/// many of its parents as make it unique ("monday/outputs", "tuesday/outputs").
std::vector<std::string> run_names(const std::vector<std::filesystem::path>& folders);

/// One run in the server's memory: read again when it goes on, when it is resumed, and whenever its
/// results.json is another file. Its folder is kept open, so that what takes its name later leads nowhere.
/// All members may be called from any thread.
class ServedRun {
 public:
  /// InputError if the folder holds no run.
  explicit ServedRun(const std::filesystem::path& folder);

  /// The folder as it was named, for people.
  const std::filesystem::path& named() const { return named_; }
  /// Where its files are read: leads to the same folder whatever becomes of the name.
  std::filesystem::path folder() const { return opened_.path(); }
  std::string started();

  /// The texts of report::overview_json, target_json and progress_json.
  std::shared_ptr<const PackedText> overview();
  std::optional<std::string> target(std::size_t index);
  std::string progress();
  /// A copy, to be compared with that of another run.
  results::RunRecord record();
  /// "orbs 1/4": only runs of the same suite and size are compared.
  std::string suite_and_size();

  /// The record of the run with those of its targets alone that have this name and renderer.
  results::RunRecord record_of(const std::string& target, const std::string& renderer);

  /// Grows whenever the run changes. Reads the folder at most once per `kPollInterval`.
  std::uint64_t version();
  bool is_live();

 private:
  void look();
  // Reads the whole folder.
  void read();

  static constexpr std::chrono::milliseconds kPollInterval{400};
  std::filesystem::path named_;
  std::mutex mutex_;
  results::RunView view_;
  OpenFolder opened_;
  std::string results_state_;  // file_state of the results.json that was read
  std::uint64_t version_ = 1;
  std::chrono::steady_clock::time_point last_look_;
  std::shared_ptr<const PackedText> overview_;  // of the current version; null until requested
};

/// One study in the server's memory. The page reads its JSON as a file of the folder, as it is
/// then. Its folder is kept open, so that what takes its name later leads nowhere.
class ServedStudy {
 public:
  /// InputError if the folder holds no study.
  explicit ServedStudy(const std::filesystem::path& folder);

  const std::filesystem::path& named() const { return named_; }
  std::filesystem::path folder() const { return opened_.path(); }
  const std::string& started() const { return study_.started; }
  std::string_view kind() const { return study_.kind.name; }

 private:
  std::filesystem::path named_;
  results::StudyFolder study_;
  OpenFolder opened_;
};

}  // namespace orbs::server

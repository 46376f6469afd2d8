#include "server/served.h"

#include "base/error.h"
#include "base/file_state.h"
#include "report/overview.h"
#include "report/progress.h"
#include "report/target_data.h"

namespace orbs::server {

// The first view is only for the messages: they name the folder as the user did.
ServedRun::ServedRun(const std::filesystem::path& folder)
    : named_(std::filesystem::weakly_canonical(folder)),
      view_(results::read_run_folder(named_)),
      opened_(named_),
      last_look_(std::chrono::steady_clock::now()) {
  read();
  view_.run.name = named_.filename().string();
}

void ServedRun::read() {
  // Its state first: a file that is written in between is read once more.
  results_state_ = file_state(folder() / "results.json");
  view_ = results::read_run_folder(folder());
}

std::string ServedRun::started() {
  const std::lock_guard lock(mutex_);
  look();
  return view_.run.started;
}

void ServedRun::look() {
  const auto now = std::chrono::steady_clock::now();
  if (now - last_look_ < kPollInterval) return;
  last_look_ = now;
  try {
    if (file_state(folder() / "results.json") != results_state_) {
      read();
    } else if (!results::refresh(view_)) {
      return;
    }
  } catch (const InputError&) {
    // The folder is gone, or holds no run any more: what was read before stays.
    view_.is_live = false;
  }
  view_.run.name = named_.filename().string();
  ++version_;
  overview_.reset();
}

std::shared_ptr<const PackedText> ServedRun::overview() {
  const std::lock_guard lock(mutex_);
  look();
  if (!overview_) overview_ = std::make_shared<const PackedText>(packed_text(report::overview_json(view_)));
  return overview_;
}

std::optional<std::string> ServedRun::target(std::size_t index) {
  const std::lock_guard lock(mutex_);
  look();
  if (index >= view_.run.targets.size()) return std::nullopt;
  return report::target_json(view_, index);
}

std::string ServedRun::progress() {
  const std::lock_guard lock(mutex_);
  return report::progress_json(view_);
}

std::uint64_t ServedRun::version() {
  const std::lock_guard lock(mutex_);
  look();
  return version_;
}

bool ServedRun::is_live() {
  const std::lock_guard lock(mutex_);
  look();
  return view_.is_live;
}

ServedStudy::ServedStudy(const std::filesystem::path& folder)
    : named_(std::filesystem::weakly_canonical(folder)),
      study_(results::read_study_folder(named_)),
      opened_(named_) {}

}  // namespace orbs::server

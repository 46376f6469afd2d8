#include "server/served_run.h"

#include "base/error.h"
#include "report/overview.h"
#include "report/progress.h"
#include "report/target_data.h"

namespace orbs::server {

ServedRun::ServedRun(const std::filesystem::path& folder)
    : folder_(std::filesystem::weakly_canonical(folder)),
      view_(results::read_run_folder(folder_)),
      last_look_(std::chrono::steady_clock::now()) {}

std::string ServedRun::started() const {
  const std::lock_guard lock(mutex_);
  return view_.run.started;
}

void ServedRun::look() {
  const auto now = std::chrono::steady_clock::now();
  if (!view_.is_live || now - last_look_ < kPollInterval) return;
  last_look_ = now;
  try {
    if (!results::refresh(view_)) return;
  } catch (const InputError&) {
    // The folder is gone, or holds no run any more: what was read before stays.
    view_.is_live = false;
  }
  ++version_;
  overview_.reset();
}

std::shared_ptr<const std::string> ServedRun::overview() {
  const std::lock_guard lock(mutex_);
  look();
  if (!overview_) overview_ = std::make_shared<const std::string>(report::overview_json(view_));
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

}  // namespace orbs::server
